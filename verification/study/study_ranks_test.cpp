#include "verification/study/study_ranks.hpp"

#include <atomic>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <unistd.h>

#include <gtest/gtest.h>

#include "wavecurve/io/files/write_file.hpp"

#include "verification/study/slowest_first.hpp"

namespace wavecurve::verification {
namespace {

/// Threads in the place of processes.
struct Post {
  std::mutex access;
  std::vector<std::deque<Ranks::Message>> boxes;
};

class ThreadRanks : public Ranks {
 public:
  ThreadRanks(Post& post, int rank) : post_(post), rank_(rank) {}
  int rank() const override { return rank_; }
  int count() const override { return static_cast<int>(post_.boxes.size()); }
  int local_rank() const override { return rank_; }
  int local_count() const override { return count(); }
  void send(int to, const std::string& text) override {
    const std::scoped_lock lock(post_.access);
    post_.boxes.at(static_cast<std::size_t>(to)).push_back({rank_, text});
  }
  std::optional<Message> poll() override {
    const std::scoped_lock lock(post_.access);
    auto& box = post_.boxes[static_cast<std::size_t>(rank_)];
    if (box.empty()) return {};
    Message message = box.front();
    box.pop_front();
    return message;
  }

 private:
  Post& post_;
  int rank_;
};

std::vector<StudyPoint> on_ranks(int count, const StudyPlan& plan, const StudyHooks& hooks = {},
                                 const StudyPlan* of_the_others = nullptr) {
  Post post;
  post.boxes.resize(static_cast<std::size_t>(count));
  StudyHooks of_others;
  of_others.stand_in = hooks.stand_in;
  std::vector<std::jthread> others;
  for (int rank = 1; rank < count; ++rank) {
    others.emplace_back([&post, &plan, &of_others, of_the_others, rank] {
      ThreadRanks ranks(post, rank);
      follow(ranks, of_the_others ? *of_the_others : plan, of_others);
    });
  }
  ThreadRanks ranks(post, 0);
  Team team(ranks);
  return run_study(team, plan, hooks);
}

StudyPlan small_plan() {
  StudySetting star;
  star.samples = 16;
  star.levels = 4;
  star.shape = "star";
  return {{{}, star}, {"decoupled", "implicit-ldlt", "massless"}};
}

TEST(StudyRanks, GiveWhatOneProcessGivesHoweverManyTheyAre) {
  const auto alone = run_study(small_plan());
  for (const int count : {1, 2, 5}) {
    std::size_t finished = 0;
    StudyHooks hooks;
    hooks.finished = [&](const StudyPoint&) { ++finished; };
    const auto points = on_ranks(count, small_plan(), hooks);
    EXPECT_EQ(finished, alone.size());
    ASSERT_EQ(points.size(), alone.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(*points[i].setting, *alone[i].setting);
      EXPECT_EQ(points[i].solver, alone[i].solver);
      EXPECT_EQ(points[i].tolerance, alone[i].tolerance);
      EXPECT_EQ(points[i].errors, alone[i].errors);
      EXPECT_EQ(points[i].model_errors, alone[i].model_errors);
      EXPECT_EQ(points[i].cost, alone[i].cost);
      EXPECT_EQ(points[i].failure, alone[i].failure);
    }
  }
}

TEST(StudyRanks, DoEachPointOnceAndOnlyWhatIsNotKnown) {
  const auto all = run_study(small_plan());
  std::mutex access;
  std::multiset<std::string> solved;
  StudyHooks hooks;
  hooks.known = [&](const auto& take) {
    for (std::size_t i = 0; i < all.size(); i += 2) take(all[i]);
  };
  hooks.stand_in = [&](StudyPoint& point) {
    const std::scoped_lock lock(access);
    solved.insert(name_of(point));
    point.failure = "stood in for";
  };
  const auto points = on_ranks(3, small_plan(), hooks);
  EXPECT_EQ(solved.size(), all.size() / 2);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(solved.count(name_of(all[i])), i % 2) << name_of(all[i]);
    EXPECT_EQ(points[i].failure == "stood in for", i % 2 == 1);
  }
}

TEST(StudyRanks, EndWithWhatAnyOfThemThrows) {
  StudyHooks hooks;
  hooks.finished = [](const StudyPoint&) { throw std::runtime_error("disk full"); };
  EXPECT_THROW(on_ranks(3, small_plan(), hooks), std::runtime_error);
  StudyPlan unknown = small_plan();
  unknown.settings[0].filter = "nope";
  EXPECT_THROW(on_ranks(3, unknown), std::invalid_argument);
  try {
    on_ranks(3, small_plan(), {}, &unknown);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("unknown filter 'nope'"), std::string::npos);
    EXPECT_EQ(std::string(error.what()).find("process "), 0u) << error.what();
  }
}

TEST(StudyRanks, EndWithWhyOneDeclines) {
  Post post;
  post.boxes.resize(2);
  const std::jthread other([&post] {
    ThreadRanks ranks(post, 1);
    decline(ranks, "no core is left");
  });
  ThreadRanks ranks(post, 0);
  Team team(ranks);
  try {
    run_study(team, small_plan());
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "process 1: no core is left");
  }
}

TEST(StudyRanks, WhatAMachineLackedIsNoResult) {
  StudyHooks hooks;
  std::atomic<int> calls = 0;
  std::size_t finished = 0;
  hooks.stand_in = [&](StudyPoint& point) {
    if (++calls == 3) throw std::bad_alloc();
    point.failure = "stood in for";
  };
  hooks.finished = [&](const StudyPoint&) { ++finished; };
  try {
    on_ranks(3, small_plan(), hooks);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("out of memory"), std::string::npos) << error.what();
  }
  EXPECT_EQ(finished + 1, points_of(small_plan()).size());
}

TEST(SlowestFirst, TakesTheUnknownAndTheSlowFirst) {
  StudyPlan plan{{}, {"implicit-ldlt"}};
  for (const Eigen::Index samples : {16, 32, 64}) {
    StudySetting setting;
    setting.samples = samples;
    setting.levels = 4;
    plan.settings.push_back(setting);
  }
  auto points = points_of(plan);  // at six steps each
  std::vector<std::size_t> open(points.size());
  for (std::size_t i = 0; i < open.size(); ++i) open[i] = i;
  SlowestFirst queue(points, open);
  EXPECT_EQ(queue.take(), 17u);  // the largest, with the smallest step
  points[17].seconds = 1;
  queue.learn(points[17]);
  // Nothing is known of the other steps; at this one N = 32 is thought to take half a second.
  EXPECT_EQ(queue.take(), 16u);
  for (std::size_t i : {12u, 13u, 14u, 15u, 16u}) {
    points[i].seconds = 0.1;
    queue.learn(points[i]);
  }
  EXPECT_EQ(queue.take(), 11u);
  std::set<std::size_t> taken = {11, 16, 17};
  while (const auto place = queue.take()) EXPECT_TRUE(taken.insert(*place).second);
  EXPECT_EQ(taken.size(), points.size());
}

}  // namespace
}  // namespace wavecurve::verification
