#include "wavecurve/curves/crossings.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

#include "wavecurve/curves/detail/orient2d.hpp"

namespace wavecurve {

namespace {

using Eigen::Index;
using Eigen::Vector2d;
using In = const Eigen::Ref<const Contour>&;

struct Edge {
  Vector2d from, to;
};

Edge edge(In contour, Index i) {
  return {contour.row(i), contour.row(i + 1 == contour.rows() ? 0 : i + 1)};
}

/// Whether the line through an edge has another one's ends on different sides.
bool separates(const Edge& line, const Edge& other) {
  const int side = orient2d(line.from, line.to, other.from);
  return side != 0 && side * orient2d(line.from, line.to, other.to) < 0;
}

bool cross(const Edge& a, const Edge& b) { return separates(a, b) && separates(b, a); }

Index edges_of(In contour, Closing closing) {
  return closing == Closing::joined ? contour.rows() : std::max<Index>(contour.rows() - 1, 0);
}

struct Box {
  Vector2d low, high;
};

bool meet(const Box& a, const Box& b) {
  return a.low.x() <= b.high.x() && b.low.x() <= a.high.x() && a.low.y() <= b.high.y() &&
         b.low.y() <= a.high.y();
}

Box hull(const Box& a, const Box& b) { return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)}; }

/// Boxes of the edges, of pairs of neighbours, of pairs of those, and so on up to a single one.
class BoxTree {
 public:
  struct Node {
    std::size_t level, place;
  };

  explicit BoxTree(In contour, Closing closing = Closing::joined) : contour_(contour) {
    if (!contour.allFinite()) {
      throw std::domain_error("a contour whose crossings are counted must have finite coordinates");
    }
    std::vector<Box> boxes;
    const Index edges = edges_of(contour, closing);
    for (Index i = 0; i < edges; ++i) {
      const Edge e = edge(contour, i);
      boxes.push_back({e.from.cwiseMin(e.to), e.from.cwiseMax(e.to)});
    }
    while (boxes.size() > 1) {
      std::vector<Box> coarser;
      for (std::size_t i = 0; i < boxes.size(); i += 2) {
        coarser.push_back(i + 1 < boxes.size() ? hull(boxes[i], boxes[i + 1]) : boxes[i]);
      }
      levels_.push_back(std::move(boxes));
      boxes = std::move(coarser);
    }
    levels_.push_back(std::move(boxes));
  }

  bool is_empty() const { return levels_.back().empty(); }
  Node root() const { return {levels_.size() - 1, 0}; }
  const Box& box(Node node) const { return levels_[node.level][node.place]; }
  Edge leaf(Node node) const { return edge(contour_, static_cast<Index>(node.place)); }
  Node first_child(Node node) const { return {node.level - 1, 2 * node.place}; }
  bool has_second_child(Node node) const {
    return 2 * node.place + 1 < levels_[node.level - 1].size();
  }
  Node second_child(Node node) const { return {node.level - 1, 2 * node.place + 1}; }

 private:
  Eigen::Ref<const Contour> contour_;
  std::vector<std::vector<Box>> levels_;
};

using Node = BoxTree::Node;

/// Crossings of the edges below one node with those below another, disjoint from the first.
Index crossings_between(const BoxTree& a, Node node_a, const BoxTree& b, Node node_b) {
  if (!meet(a.box(node_a), b.box(node_b))) return 0;
  if (node_a.level == 0 && node_b.level == 0) return cross(a.leaf(node_a), b.leaf(node_b));
  if (node_a.level < node_b.level) return crossings_between(b, node_b, a, node_a);
  Index count = crossings_between(a, a.first_child(node_a), b, node_b);
  if (a.has_second_child(node_a)) count += crossings_between(a, a.second_child(node_a), b, node_b);
  return count;
}

Index crossings_within(const BoxTree& tree, Node node) {
  if (node.level <= 1) return 0;  // two edges that share an end do not cross
  const Node first = tree.first_child(node);
  if (!tree.has_second_child(node)) return crossings_within(tree, first);
  const Node second = tree.second_child(node);
  return crossings_within(tree, first) + crossings_within(tree, second) +
         crossings_between(tree, first, tree, second);
}

}  // namespace

Index count_crossings(In contour, Closing closing) {
  const BoxTree tree(contour, closing);
  return tree.is_empty() ? 0 : crossings_within(tree, tree.root());
}

Index count_crossings(In a, In b) {
  const BoxTree tree_a(a), tree_b(b);
  if (tree_a.is_empty() || tree_b.is_empty()) return 0;
  return crossings_between(tree_a, tree_a.root(), tree_b, tree_b.root());
}

Index count_crossings(const std::vector<Contour>& outline) {
  Index count = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    count += count_crossings(outline[i]);
    for (std::size_t j = 0; j < i; ++j) count += count_crossings(outline[i], outline[j]);
  }
  return count;
}

}  // namespace wavecurve

namespace wavecurve::plain {

Eigen::Index count_crossings(In contour, Closing closing) {
  Index count = 0;
  for (Index i = 0; i < edges_of(contour, closing); ++i) {
    for (Index j = 0; j < i; ++j) count += cross(edge(contour, i), edge(contour, j));
  }
  return count;
}

Eigen::Index count_crossings(In a, In b) {
  Index count = 0;
  for (Index i = 0; i < a.rows(); ++i) {
    for (Index j = 0; j < b.rows(); ++j) count += cross(edge(a, i), edge(b, j));
  }
  return count;
}

}  // namespace wavecurve::plain
