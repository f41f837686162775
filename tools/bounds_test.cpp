// Every reader is bounded, and what is computed from a user's own input ends within seconds or is refused:
// each command runs with 4 GiB of address space and 30 seconds of the processor, several times what
// it takes.
#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "wavecurve/io/files/write_file.hpp"

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

/// made(0) + made(1) + ... with `times` terms.
template <class Make>
std::string joined(int times, Make made) {
  std::string result;
  for (int i = 0; i < times; ++i) result += made(i);
  return result;
}

std::string svg(const std::string& body) {
  return "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 99 99'>" + body + "</svg>";
}

const std::string square = "<path d='M0 0H9V9H0Z'/>";

/// What a sanitizer adds is shadow memory of terabytes, and ten times the work.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr const char* limits = "ulimit -t 300; ";
#else
constexpr const char* limits = "ulimit -v 4194304; ulimit -t 30; ";
#endif

class Bounds : public ProgramTest {
 protected:
  void put(const std::string& name, const std::string& text) const {
    io::write_file(folder_ / name, text);
  }

  ProgramRun bounded(const std::string& arguments) const {
    return run("cd '" + folder_.string() + "' && { " + limits + "'" WAVECURVE_PROGRAM "' " +
               arguments + "; }");
  }

  /// Expects an end with this code, and little said on the error stream.
  void expect_end(const std::string& arguments, int code, const std::string& text = "",
                  long most_lines = 1) const {
    const ProgramRun ended = bounded(arguments);
    EXPECT_EQ(ended.exit_code, code) << arguments << ": " << ended.err.substr(0, 300);
    EXPECT_NE(ended.err.find(text), std::string::npos)
        << arguments << ": " << ended.err.substr(0, 300);
    EXPECT_LE(std::count(ended.err.begin(), ended.err.end(), '\n'), most_lines) << arguments;
    EXPECT_LE(ended.err.size(), 10'000u) << arguments;
  }
};

TEST_F(Bounds, EndlessFilesAreRefused) {
  for (const char* name : {"zero.json", "zero.csv", "zero.svg", "zero.svgz", "zero.txt"}) {
    std::filesystem::create_symlink("/dev/zero", folder_ / name);
  }
  put("a.svg", svg(square));
  for (const char* arguments :
       {"filter zero.json", "coefficients zero.json", "stiffness zero.json", "check zero.csv",
        "identify zero.txt", "describe zero.svg", "describe zero.csv", "describe zero.svgz",
        "morph a.svg zero.svg -o b.svg", "reconstruct zero.json -o b.svg", "gait show zero.json",
        "gait fit zero.csv -o p.json", "gait synthesize zero.json a.svg -o b.svg",
        "verify --only table-1 --output v --reference zero.json", "compare --shape zero.svg",
        "bench compare zero.json zero.json"}) {
    expect_end(arguments, 2, "zero");
  }
}

TEST_F(Bounds, StyleSheetsAreNotMultipliedOut) {
  put("css.svg", svg("<style>" + repeated("a,", 30'000) + "a{" + repeated("x:1;", 15'000) +
                     "}</style>" + square));
  expect_end("describe css.svg", 0);
  put("rules.svg",
      svg("<style>" + repeated("path{fill:red}", 20'000) + "</style>" + repeated(square, 20'000)));
  expect_end("describe rules.svg", 2, "steps to apply the style sheet");
  put("stops.svg",
      svg("<linearGradient id='a'>" + repeated("<stop stop-color='red'/>", 20'000) +
          "</linearGradient>" + repeated("<path fill='url(#a)' d='M0 0H9V9H0Z'/>", 20'000)));
  expect_end("describe stops.svg", 2, "steps to apply the style sheet");
}

TEST_F(Bounds, WarningsAreTwentyOfAKindAndACount) {
  put("broken.svg",
      svg(joined(100'000, [](int i) { return fmt::format("<x{}/>", i); }) +
          joined(100, [](int i) { return fmt::format("<path id='p{}' d='M1 1'/>", i); }) + square));
  expect_end("describe broken.svg", 0, "99980 more like \"the element x19 is not supported\"", 42);
  expect_end("describe broken.svg", 0, "80 more like \"line 1: p19 has no length\"", 42);
}

TEST_F(Bounds, AHundredThousandContours) {
  put("many.svg", svg("<path d='" +
                      joined(100'000,
                             [](int i) {
                               return fmt::format("M{} {}h1v1h-1z", 3 * (i % 300), 3 * (i / 300));
                             }) +
                      "'/>"));
  put("one.svg", svg(square));
  expect_end("morph many.svg one.svg --samples 16 --frames 2 -o a.json", 0);
  expect_end("morph many.svg one.svg -o a.json", 2, "100000 contours; of 1024 samples each");
  expect_end("morph many.svg many.svg --samples 4 -o a.json", 2, "cannot be matched");
  put("layers.svg", svg(repeated(square, 50'000)));
  expect_end("morph one.svg layers.svg -o a.json", 2, "layers");
}

TEST_F(Bounds, OwnFilters) {
  const auto taps = [](const std::string& all) { return R"({"sum": "2", "taps": [)" + all + "]}"; };
  put("box.json", taps(repeated("\"1/500\",", 999) + "\"1/500\""));
  put("tiny.json", taps(repeated("\"1e-10000\",", 999) + "\"1\""));
  put("huge.json", taps("\"1e999999999\", \"1\""));
  put("name.json", R"({"taps": ["1", "1"], "name": ")" + repeated("x", 500'000) + "\"}");
  for (const char* command : {"filter", "coefficients", "stiffness"}) {
    for (const char* file : {"box", "tiny", "huge", "name"}) {
      expect_end(fmt::format("{} {}.json", command, file), 2);
    }
  }
  for (const int count : {50, 100, 200}) {
    put("lazy.json", taps("\"1\"," + repeated("\"0\",", count - 2) + "\"1\""));
    expect_end("filter lazy.json", 0);
    expect_end("coefficients lazy.json", 2, "Sobolev exponent");
  }
}

TEST_F(Bounds, Tables) {
  const std::string header = "filter,quantity,index,printed\n";
  put("filters.csv", header + joined(5000, [](int i) {
                       return fmt::format("bspline{}.{},h,0,1\n", 1 + i % 100,
                                          1 + i % 2 + 2 * (i / 100));
                     }));
  expect_end("check filters.csv", 2, "more than 200 filters");
  put("rows.csv",
      header + joined(100'000, [](int i) { return fmt::format("db4,alpha,{0},1.{0}\n", i); }));
  expect_end("check rows.csv", 2, "out of range");
  put("zeros.csv",
      header + joined(100'000, [](int i) { return fmt::format("db4,h,{},0\n", 8 + i); }));
  expect_end("check zeros.csv", 0);
  put("far.csv", header + "db4,h,-1000000000,0.5\ndb4,h,1000000000,0.25\n");
  expect_end("check far.csv", 2, "out of range");
  put("exponent.csv", header + "db4,h,0,1e999999999\n");
  expect_end("check exponent.csv", 2, "exponent");
  put("braces.csv",
      header + "db4," + repeated("dual(", 1500) + "h" + repeated(")", 1500) + ",0,1\n");
  expect_end("check braces.csv", 2);
}

TEST_F(Bounds, Lists) {
  put("columns.txt", repeated("0.4829629131 0.8365163037 0.2241438680 -0.1294095226\n", 20'000));
  expect_end("identify columns.txt", 2, "numbers");
  put("lists.txt",
      repeated("h = [0.4829629131, 0.8365163037, 0.2241438680, -0.1294095226]\n", 1000));
  expect_end("identify lists.txt", 0);
  put("digits.txt", "0.5 " + repeated("1", 1'000'000) + ".5 0.25\n1e999999999 -1e-999999999 2\n");
  expect_end("identify digits.txt", 1);
  put("nested.txt", repeated("[", 100'000) + "0.5" + repeated("]", 100'000));
  expect_end("identify nested.txt", 1);
}

TEST_F(Bounds, SolversSayThatTheyWouldTakeTooLong) {
  put("a.svg", svg(square));
  put("b.svg", svg("<circle cx='5' cy='5' r='4'/>"));
  for (const char* solver : {"coupled", "coupled-dormand-prince", "coupled-dense"}) {
    expect_end(fmt::format("morph a.svg b.svg --motion physical --solver {} -o c.json", solver), 2,
               "too stiff or too large");
  }
  expect_end("stiffness db4 --samples 1048576", 2);
  expect_end("coefficients db4 --quantity phi --level 1000000000", 2, "10");
  expect_end("coefficients db4 --quantity 'moment(phi)' --moments 1000000000", 2, "100");
  expect_end("coefficients db4 --derivatives 1000000000,1", 2, "8");
  expect_end("coefficients db4 --digits 1000000000", 2, "1000");
}

}  // namespace
}  // namespace wavecurve::tools
