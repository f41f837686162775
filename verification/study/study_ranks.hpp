#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "verification/study/solver_study.hpp"

namespace wavecurve::verification {

/// The processes that do one study together, on one machine or many. Rank 0 leads.
class Ranks {
 public:
  struct Message {
    int from;
    std::string text;
  };

  virtual ~Ranks() = default;
  virtual int rank() const = 0;
  virtual int count() const = 0;
  /// Among those on the same machine.
  virtual int local_rank() const = 0;
  virtual int local_count() const = 0;
  virtual void send(int to, const std::string& text) = 0;
  /// A message that has come, if one has.
  virtual std::optional<Message> poll() = 0;
};

/// What rank 0 is to the others. It must be there before anything can fail, for its end sends the
/// others home: they end after the points that they are at.
class Team {
 public:
  explicit Team(Ranks& ranks) : ranks_(ranks) {}
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;
  ~Team();

  /// A message of one of the others, if there is one.
  std::optional<Ranks::Message> poll();
  void send(int to, const std::string& text);

 private:
  Ranks& ranks_;
  std::set<int> waiting_;  ///< those that have said what they had to say
};

/// run_study() on several processes. Rank 0 hands the points out one by one, slowest first
/// (slowest_first.hpp), and solves some itself. It returns the points: the same as those of one process,
/// but for their times. What another process throws, this throws as std::runtime_error naming it. Throws
/// as run_study() does.
std::vector<StudyPoint> run_study(Team& team, const StudyPlan& plan, const StudyHooks& hooks = {},
                                  const Shard& shard = {});

/// What the others do meanwhile, with the same plan and shard. The stand-in is the only hook that counts.
void follow(Ranks& ranks, const StudyPlan& plan, const StudyHooks& hooks = {},
            const Shard& shard = {});

/// What another process does that cannot take part: tells rank 0 why, which throws it, and waits to be
/// sent home.
void decline(Ranks& ranks, const std::string& why);

}  // namespace wavecurve::verification
