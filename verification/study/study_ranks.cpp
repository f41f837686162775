#include "verification/study/study_ranks.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <exception>
#include <future>
#include <map>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "wavecurve/certified/detail/thread_cache.hpp"

#include "verification/study/slowest_first.hpp"
#include "verification/study/study_json.hpp"
#include "verification/study/study_work.hpp"

namespace wavecurve::verification {

namespace {

using namespace std::chrono_literals;

// What is sent: the leader sends the place of a point, or `stop`; the others `ready`, then for each place
// a word, the place, and the point's line or what there is instead.
constexpr std::string_view stop = "stop", ready = "ready", solved = "solved", lacks = "lacks",
                           fails = "fails";

void rest() { std::this_thread::sleep_for(200us); }

Ranks::Message receive(Ranks& ranks) {
  for (;;) {
    if (auto message = ranks.poll()) return *std::move(message);
    rest();
  }
}

/// "word place text".
struct Answer {
  std::string_view word, text;
  std::size_t place = 0;

  explicit Answer(std::string_view message) {
    word = message.substr(0, message.find(' '));
    message.remove_prefix(std::min(word.size() + 1, message.size()));
    const std::string_view number = message.substr(0, message.find(' '));
    std::from_chars(number.data(), number.data() + number.size(), place);
    text = message.substr(std::min(number.size() + 1, message.size()));
  }
};

std::string answer(std::string_view word, std::size_t place, const std::string& text) {
  return fmt::format("{} {} {}", word, place, text);
}

/// What rank 0 does.
class Leader {
 public:
  Leader(Team& team, StudyWork& study, const StudyHooks& hooks)
      : team_(team),
        study_(study),
        hooks_(hooks),
        open_(study.open()),
        queue_(study.points(), open_),
        done_(study.points().size() - open_.size()) {}

  void run() {
    while (done_ < study_.points().size()) step();
    if (!lacking_.empty()) {
      fail_for_lack(study_.points()[lacking_.begin()->first], lacking_.begin()->second,
                    lacking_.size());
    }
  }

 private:
  void step() {
    if (const auto message = team_.poll()) {
      hear(*message);
    } else if (own_ && own_->wait_for(0s) == std::future_status::ready) {
      const auto place = own_place_;
      const std::string lack = std::exchange(own_, std::nullopt)->get();
      finish(place, lack);
    } else if (!own_ && start()) {
    } else {
      rest();
    }
  }

  void hear(const Ranks::Message& message) {
    const Answer answer(message.text);
    if (answer.word == fails) {
      throw std::runtime_error(fmt::format("process {}: {}", message.from, answer.text));
    }
    if (answer.word != ready) {
      if (answer.word == solved) take_over(answer.place, std::string(answer.text));
      finish(answer.place, std::string(answer.word == lacks ? answer.text : ""));
    }
    hand_out(message.from);
  }

  void take_over(std::size_t place, const std::string& line) {
    StudyPoint& mine = study_.points().at(place);
    StudyPoint point = point_of_json_line(line);
    if (point.fingerprint != mine.fingerprint) {
      throw std::runtime_error(
          fmt::format("{}: a filter or a shape is another file's at one process than at another",
                      name_of(mine)));
    }
    point.setting = mine.setting;
    mine = std::move(point);
  }

  void finish(std::size_t place, const std::string& lack) {
    const StudyPoint& point = study_.points()[place];
    queue_.learn(point);
    if (!lack.empty()) lacking_[place] = lack;
    if (lack.empty() && hooks_.finished) hooks_.finished(point);
    ++done_;
    if (hooks_.progress) hooks_.progress(done_, study_.points().size());
  }

  void hand_out(int rank) {
    if (const auto place = queue_.take()) team_.send(rank, std::to_string(*place));
  }

  /// A point for this process itself, on a thread of its own, so that the others need not wait.
  bool start() {
    const auto place = queue_.take();
    if (!place) return false;
    own_place_ = *place;
    own_ = std::async(std::launch::async, [this, place = *place] {
      const certified::ThreadCache cache;
      return study_.solve(place, hooks_);
    });
    return true;
  }

  Team& team_;
  StudyWork& study_;
  const StudyHooks& hooks_;
  std::vector<std::size_t> open_;
  SlowestFirst queue_;
  std::size_t done_;
  std::map<std::size_t, std::string> lacking_;
  std::size_t own_place_ = 0;
  std::optional<std::future<std::string>> own_;
};

}  // namespace

Team::~Team() {
  while (static_cast<int>(waiting_.size()) < ranks_.count() - 1) {
    waiting_.insert(receive(ranks_).from);
  }
  for (const int rank : waiting_) ranks_.send(rank, std::string(stop));
}

std::optional<Ranks::Message> Team::poll() {
  auto message = ranks_.poll();
  if (message) waiting_.insert(message->from);
  return message;
}

void Team::send(int to, const std::string& text) {
  waiting_.erase(to);
  ranks_.send(to, text);
}

std::vector<StudyPoint> run_study(Team& team, const StudyPlan& plan, const StudyHooks& hooks,
                                  const Shard& shard) {
  StudyWork study(plan, shard);
  if (hooks.known) study.take_up(hooks.known);
  Leader(team, study, hooks).run();
  return std::move(study.points());
}

void follow(Ranks& ranks, const StudyPlan& plan, const StudyHooks& hooks, const Shard& shard) {
  const certified::ThreadCache cache;
  try {
    StudyWork study(plan, shard);
    ranks.send(0, std::string(ready));
    for (;;) {
      const std::string text = receive(ranks).text;
      if (text == stop) return;
      const std::size_t place = std::stoul(text);
      const std::string lack = study.solve(place, hooks);
      ranks.send(0, lack.empty() ? answer(solved, place, to_json_line(study.points().at(place)))
                                 : answer(lacks, place, lack));
    }
  } catch (const std::exception& error) {
    decline(ranks, error.what());
  }
}

void decline(Ranks& ranks, const std::string& why) {
  ranks.send(0, answer(fails, 0, why));
  receive(ranks);  // to stop
}

}  // namespace wavecurve::verification
