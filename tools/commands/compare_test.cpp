#include <algorithm>
#include <filesystem>
#include <string>
#include <thread>

#include <nlohmann/json.hpp>

#include "wavecurve/io/files/write_file.hpp"

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

using CompareCommand = ProgramTest;

TEST_F(CompareCommand, WritesOnePointASolverAndTolerance) {
  const ProgramRun run = wavecurve(
      "compare --shape ellipse --damping 0,0 --solvers decoupled,coupled --format json -o study");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(io::read_file(folder_ / "study" / "compare.json"), run.out);
  const auto points = nlohmann::json::parse(run.out)["points"];
  ASSERT_GT(points.size(), 2u);
  const auto& first = points[0];
  EXPECT_EQ(first["solver"], "decoupled");
  EXPECT_EQ(first["filter"], "db4");
  EXPECT_EQ(first["samples"], 64);
  EXPECT_EQ(first["levels"], 6);
  EXPECT_EQ(first["shape"], "ellipse");
  EXPECT_EQ(first["damping"], nlohmann::json({0, 0}));
  EXPECT_TRUE(first["tolerance"].is_null());
  EXPECT_GT(first["error"]["displacement_l2_max"], 1.3);
  EXPECT_TRUE(first["error"].contains("displacement_l2_final"));
  EXPECT_TRUE(first["error"].contains("energy_norm_max"));
  EXPECT_TRUE(first["cost"].contains("evaluations"));
  EXPECT_GT(first["cost"]["seconds"], 0);
  EXPECT_EQ(first["status"], "ok");
  EXPECT_EQ(points[1]["solver"], "coupled");
  EXPECT_GT(points[1]["tolerance"], 0);
}

TEST_F(CompareCommand, KeepsFailedSolves) {
  const ProgramRun json =
      wavecurve("compare --shape ellipse --damping 0,0 --solvers massless --format json");
  ASSERT_EQ(json.exit_code, 0) << json.err;
  const auto point = nlohmann::json::parse(json.out)["points"][0];
  EXPECT_EQ(point["status"], "failed");
  EXPECT_TRUE(point["error"].is_null());
  const ProgramRun csv =
      wavecurve("compare --shape ellipse --damping 0,0 --solvers massless,spectral --format csv");
  EXPECT_NE(csv.out.find(",failed\n"), std::string::npos);
  EXPECT_NE(csv.out.find(",ok\n"), std::string::npos);
  const ProgramRun text = wavecurve("compare --shape ellipse --damping 0,0 --solvers massless");
  EXPECT_NE(text.out.find("failed: density is 1"), std::string::npos) << text.out;
}

TEST_F(CompareCommand, TakesADrawingDampingAndLevels) {
  io::write_file(folder_ / "disc.svg",
                 R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10">
                    <ellipse cx="5" cy="5" rx="4" ry="3"/></svg>)");
  const std::string arguments = "compare --shape disc.svg --solvers decoupled --format json ";
  const auto error = [&](const std::string& more) -> double {
    const ProgramRun run = wavecurve(arguments + more);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return nlohmann::json::parse(run.out)["points"][0]["error"]["displacement_l2_max"];
  };
  EXPECT_GT(error("--damping 0,0"), 0.5);
  EXPECT_LT(error("--damping 0,10"), 0.01);
  EXPECT_NE(error("--levels 2"), error("--levels 3"));
}

TEST_F(CompareCommand, SweepsTheProductOfItsLists) {
  const ProgramRun run = wavecurve(
      "compare --filter db4,coif2 --samples 16,32 --levels 3,4 --shape star,dent --damping 0,0 "
      "--damping 1,0.5 --solvers decoupled,block-decoupled --format json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto study = nlohmann::json::parse(run.out);
  ASSERT_EQ(study["points"].size(), 64u);
  EXPECT_EQ(study["floors"].size(), 64u);
  EXPECT_EQ(study["floors"][1]["solver"], "block-decoupled");
  EXPECT_EQ(study["floors"][1]["cause"], "model");
  EXPECT_EQ(study["points"][3]["damping"], nlohmann::json({1, 0.5}));
  EXPECT_EQ(study["points"][63]["filter"], "coif2");
  EXPECT_EQ(study["points"][63]["levels"], 4);
}

TEST_F(CompareCommand, NamesFloorsOrdersAndGrowth) {
  const ProgramRun text = wavecurve(
      "compare --samples 16,32,64 --shape star --damping 0,0 --solvers decoupled,implicit-ldlt "
      "-o study");
  ASSERT_EQ(text.exit_code, 0) << text.err;
  EXPECT_NE(text.out.find("decoupled: floor 1."), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("implicit-ldlt: observed order 2.0"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("implicit-ldlt at 0.000488, N = 16 to 64: operations N^"),
            std::string::npos)
      << text.out;
  EXPECT_TRUE(text.out.ends_with("\nreport: study/index.html\n")) << text.out;
  const auto study = nlohmann::json::parse(io::read_file(folder_ / "study" / "compare.json"));
  EXPECT_NEAR(study["orders"][0]["order"]["exponent"], 2, 0.1);
  EXPECT_EQ(study["growth"].size(), 3u);  // at one accuracy, at two
  const std::string page = io::read_file(folder_ / "study" / "index.html");
  EXPECT_NE(page.find("decoupled: floor 1."), std::string::npos);
  for (const char* figure : {"floors", "work-precision-1", "work-precision-3", "model-error-2"}) {
    EXPECT_NE(page.find("id=\"figure-" + std::string(figure) + "\""), std::string::npos) << figure;
    EXPECT_TRUE(exists(folder_ / "study" / "figures" / (figure + std::string(".svg"))));
  }
}

/// compare.json without what differs from run to run.
nlohmann::json without_times(const std::filesystem::path& file) {
  auto study = nlohmann::json::parse(io::read_file(file));
  for (auto& point : study["points"]) point["cost"].erase("seconds");
  for (auto& growth : study["growth"]) growth.erase("seconds");
  return study;
}

TEST_F(CompareCommand, ResumesAfterAKill) {
  const std::string arguments =
      "compare --samples 16 --shape star --damping 0,0 --damping 0,0.1 --format csv "
      "--solvers decoupled,implicit-rosenbrock,implicit -o ";
  ASSERT_EQ(wavecurve(arguments + "whole").exit_code, 0);
  // SIGKILL as soon as a few points are there, in the middle of the work.
  const ProgramRun killed =
      run("cd '" + folder_.string() + "' && { '" WAVECURVE_PROGRAM "' " + arguments +
          "part & p=$!; while [ \"$(cat part/compare.points.jsonl "
          "2>/dev/null | wc -l)\" -lt 4 ]; do sleep 0.001; done; "
          "kill -9 $p; wait $p; }");
  EXPECT_EQ(killed.exit_code, 128 + 9);
  EXPECT_FALSE(exists(folder_ / "part" / "compare.json"));
  const auto journal = folder_ / "part" / "compare.points.jsonl";
  const std::string kept = io::read_file(journal);
  io::write_file(journal, kept + "{\"solver\": \"implicit");  // as if a write had been cut short
  ASSERT_EQ(wavecurve(arguments + "part").exit_code, 0);
  EXPECT_TRUE(io::read_file(journal).starts_with(kept));
  const auto lines = [](const std::string& text) { return std::ranges::count(text, '\n'); };
  EXPECT_EQ(lines(io::read_file(journal)),
            lines(io::read_file(folder_ / "whole" / "compare.points.jsonl")));
  EXPECT_EQ(without_times(folder_ / "part" / "compare.json"),
            without_times(folder_ / "whole" / "compare.json"));
}

const std::string small_study =
    "compare --samples 16 --shape star,dent --damping 0,0 --damping 0,0.1 "
    "--solvers decoupled,implicit-ldlt ";

TEST_F(CompareCommand, JoinsShardsToTheWhole) {
  ASSERT_EQ(wavecurve(small_study + "-o whole").exit_code, 0);
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    const std::string folder = std::string("part") + shard[0];
    const ProgramRun run = wavecurve(small_study + "--shard " + shard + " -o " + folder);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.out.find(std::string("shard ") + shard + ": "), 0u) << run.out;
    EXPECT_FALSE(exists(folder_ / folder / "compare.json"));
  }
  const ProgramRun part = wavecurve("compare --merge part1 part3 -o joined");
  EXPECT_EQ(part.exit_code, 1);
  EXPECT_NE(part.err.find(" points are missing; "), std::string::npos) << part.err;
  const ProgramRun joined =
      wavecurve("compare --merge part1 part2 part3 part1/. joined -o joined --format json");
  EXPECT_EQ(joined.exit_code, 0) << joined.err;
  EXPECT_EQ(joined.out, io::read_file(folder_ / "joined" / "compare.json"));
  EXPECT_EQ(without_times(folder_ / "joined" / "compare.json"),
            without_times(folder_ / "whole" / "compare.json"));
  EXPECT_TRUE(exists(folder_ / "joined" / "index.html"));
  // The command of the study finds everything there.
  const std::string journal = io::read_file(folder_ / "joined" / "compare.points.jsonl");
  EXPECT_EQ(wavecurve(small_study + "-o joined").exit_code, 0);
  EXPECT_EQ(io::read_file(folder_ / "joined" / "compare.points.jsonl"), journal);
}

TEST_F(CompareCommand, JobArraysGiveTheWhole) {
  const std::string arguments = small_study.substr(std::string("compare ").size());
  ASSERT_EQ(wavecurve(small_study + "-o whole").exit_code, 0);
  const std::string examples = std::string(WAVECURVE_SOURCE_DIR) + "/docs/examples/";
  const std::string path =
      "PATH='" + std::filesystem::path(WAVECURVE_PROGRAM).parent_path().string() + "':\"$PATH\" ";
  const std::string in_folder = "cd '" + folder_.string() + "' && ";
  // As Slurm runs the script, once a task.
  const ProgramRun slurm = run(in_folder + "mkdir slurm && cd slurm && for i in 1 2 3; do " + path +
                               "SLURM_ARRAY_TASK_ID=$i SLURM_ARRAY_TASK_MAX=3 '" + examples +
                               "study-array.slurm' " + arguments + " || exit; done && " + path +
                               "wavecurve compare --merge study/part-* -o study");
  ASSERT_EQ(slurm.exit_code, 0) << slurm.err;
  EXPECT_EQ(without_times(folder_ / "slurm" / "study" / "compare.json"),
            without_times(folder_ / "whole" / "compare.json"));
  if (run("parallel --version </dev/null").out.find("GNU parallel") == std::string::npos) {
    GTEST_SKIP() << "GNU parallel is missing";
  }
  const ProgramRun parallel = run(in_folder + path + "HOME='" + folder_.string() + "' '" +
                                  examples + "study-parallel.sh' " + arguments + " </dev/null");
  ASSERT_EQ(parallel.exit_code, 0) << parallel.err;
  EXPECT_EQ(without_times(folder_ / "study" / "compare.json"),
            without_times(folder_ / "whole" / "compare.json"));
}

#ifdef WAVECURVE_MPIRUN

/// Open MPI refuses root, and more processes than cores, unless it is told not to.
std::string mpirun(int processes) {
  return "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
         "OMPI_MCA_rmaps_base_oversubscribe=1 '" WAVECURVE_MPIRUN "' -n " +
         std::to_string(processes) + " '" WAVECURVE_PROGRAM "' ";
}

TEST_F(CompareCommand, UnderMpirunGivesTheSamePoints) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "MPI itself is not instrumented";
#endif
  ASSERT_EQ(wavecurve(small_study + "-o whole").exit_code, 0);
  const std::string in_folder = "cd '" + folder_.string() + "' && ";
  for (const int processes : {2, 5}) {
    const std::string folder = "on" + std::to_string(processes);
    const ProgramRun ranks = run(in_folder + mpirun(processes) + small_study + "-o " + folder);
    ASSERT_EQ(ranks.exit_code, 0) << ranks.err;
    EXPECT_EQ(ranks.err, "");
    EXPECT_EQ(std::ranges::count(ranks.out, '\n'),
              std::ranges::count(wavecurve(small_study + "-o whole").out, '\n'));
    EXPECT_EQ(without_times(folder_ / folder / "compare.json"),
              without_times(folder_ / "whole" / "compare.json"));
  }
  // What is wrong is said once.
  const ProgramRun refused = run(in_folder + mpirun(3) + "compare --filter nope -o nothing");
  EXPECT_NE(refused.exit_code, 0);
  const auto first = refused.err.find("wavecurve: unknown filter 'nope'");
  EXPECT_NE(first, std::string::npos) << refused.err;
  EXPECT_EQ(refused.err.find("wavecurve: ", first + 1), std::string::npos) << refused.err;
}

TEST_F(CompareCommand, UnderMpirunARankThatDiesEndsTheRunAndTheSameCommandResumes) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "MPI itself is not instrumented";
#endif
  const std::string arguments =
      "compare --samples 64 --shape star --damping 0,0 --damping 0,0.1 --solvers decoupled,implicit "
      "-o part";
  // The second process is killed as soon as a few points are there.
  const ProgramRun killed = run(
      "cd '" + folder_.string() + "' && { " + mpirun(2) + arguments +
      " & while [ \"$(cat part/compare.points.jsonl 2>/dev/null | wc -l)\" -lt 2 ]; do "
      "sleep 0.001; done; "
      "for p in $(pgrep -f 'compare --samples 64 .* -o part'); do "
      "tr '\\0' '\\n' </proc/$p/environ | grep -q '^OMPI_COMM_WORLD_RANK=1' && kill -9 $p; done; "
      "wait; } >/dev/null 2>messages; grep -c '^wavecurve: ' messages");
  EXPECT_EQ(killed.out, "0\n");  // mpirun says it
  EXPECT_FALSE(exists(folder_ / "part" / "compare.json"));
  const ProgramRun again = run("cd '" + folder_.string() + "' && " + mpirun(2) + arguments);
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(exists(folder_ / "part" / "compare.json"));
}

TEST_F(CompareCommand, UnderMpirunKeepsEachProcessToACore) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "MPI itself is not instrumented";
#endif
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  const ProgramRun fit = run(mpirun(2) + small_study + "--one-a-core");
  if (cores >= 2) {
    EXPECT_EQ(fit.exit_code, 0) << fit.err;
    EXPECT_TRUE(
        fit.out.ends_with("measured with 2 side by side, each process on a core of its own\n"));
  }
  const ProgramRun many = run(mpirun(cores + 1) + small_study + "--one-a-core");
  EXPECT_NE(many.exit_code, 0);
  EXPECT_NE(many.err.find("processes on a machine of"), std::string::npos) << many.err;
  expect_refusal("compare --one-a-core", "mpirun");
}

#endif

TEST_F(CompareCommand, RefusesShardsThatDoNotFit) {
  ASSERT_EQ(wavecurve(small_study + "--shard 1/40 -o a").exit_code, 0);
  ASSERT_EQ(wavecurve("compare --samples 16 --solvers decoupled --shard 1/2 -o b").exit_code, 0);
  expect_refusal("compare --merge a b -o c", "a and b are of different studies");
  expect_refusal("compare --merge a missing -o c", "missing/compare.plan.json");
  expect_refusal("compare --merge a", "--merge needs -o DIR");
  expect_refusal("compare --shard 1/2", "--shard needs -o DIR");
  for (const char* shard :
       {"0/2", "3/2", "1", "/", "1/", "/2", "1/2/3", "a/b", "-1/2", "1/2000000"}) {
    expect_refusal(std::string("compare -o c --shard=") + shard, "I/N");
  }
  // The file of that name was another one on the other machine.
  const std::string drawing = "compare --samples 16 --shape hull.csv --solvers decoupled -o ";
  for (const char* folder : {"d", "e"}) {
    io::write_file(folder_ / "hull.csv",
                   std::string("x,y\n0,0\n3,0\n3,2\n0,") + (*folder == 'd' ? "1\n" : "2\n"));
    ASSERT_EQ(wavecurve(drawing + folder).exit_code, 0);
  }
  expect_refusal("compare --merge d e -o f", "d and e disagree about decoupled");
}

TEST_F(CompareCommand, WhatTheMachineLackedIsNoResult) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer needs all addresses";
#endif
  // Its dense matrix has 128 MiB, and there are copies of it.
  const std::string command = "cd '" + folder_.string() + "' && ulimit -v 300000 && { '" +
                              WAVECURVE_PROGRAM
                              "' compare --samples 4096 --shape star --damping 0,0 "
                              "--solvers decoupled,coupled-dense -o study; }";
  for (int i = 0; i < 2; ++i) {  // tried again by the next run
    const ProgramRun lacking = run(command);
    EXPECT_EQ(lacking.exit_code, 3);
    EXPECT_TRUE(lacking.err.starts_with("wavecurve: not measured, for the machine failed: "))
        << lacking.err;
    EXPECT_NE(lacking.err.find(": out of memory, and "), std::string::npos) << lacking.err;
    EXPECT_EQ(std::ranges::count(lacking.err, '\n'), 1) << lacking.err;
    const std::string journal = io::read_file(folder_ / "study" / "compare.points.jsonl");
    EXPECT_EQ(journal.find("coupled-dense"), std::string::npos) << journal;
    EXPECT_EQ(journal.find("failed"), std::string::npos) << journal;
  }
}

TEST_F(CompareCommand, NamesAlteredLinesAndLeavesAloneWhatIsNoJournal) {
  const std::string arguments =
      "compare --samples 16 --shape star --damping 0,0 --solvers decoupled,spectral -o study";
  ASSERT_EQ(wavecurve(arguments).exit_code, 0);
  const auto file = folder_ / "study" / "compare.points.jsonl";
  std::string journal = io::read_file(file);
  journal.replace(journal.find("\"displacement_l2_max\":1"), 23, "\"displacement_l2_max\":2");
  io::write_file(file, journal);
  const auto before = without_times(folder_ / "study" / "compare.json");
  const ProgramRun again = wavecurve(arguments);
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_EQ(again.err,
            "wavecurve: study/compare.points.jsonl: line 1 altered, or no point of this "
            "version; measured anew\n");
  EXPECT_EQ(without_times(folder_ / "study" / "compare.json"), before);
  io::write_file(file, "a letter\n");
  const ProgramRun refused = wavecurve(arguments);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("is no journal of a study"), std::string::npos) << refused.err;
  EXPECT_EQ(io::read_file(file), "a letter\n");
}

TEST_F(CompareCommand, RefusesBadInput) {
  expect_refusal("compare --samples 63", "63");
  expect_refusal("compare --samples 64 --levels 7", "7");
  expect_refusal("compare --shape blob", "ellipse, star, dent");
  expect_refusal("compare --damping -1,0", "-1");
  expect_refusal("compare --damping 1", "--damping");
  expect_refusal("compare --damping 0,0,1", "--damping");
  expect_refusal("compare --samples 64,48", "48");
  expect_refusal("compare --samples 16,64 --levels 6", "6");
  expect_refusal("compare --solvers magic", "magic");
  expect_refusal("compare --filter nope", "unknown filter 'nope'");
  expect_refusal("compare --shape missing.svg", "missing.svg");
  io::write_file(folder_ / "file", "");
  EXPECT_EQ(wavecurve("compare --solvers spectral -o file").exit_code, 3);
}

}  // namespace
}  // namespace wavecurve::tools
