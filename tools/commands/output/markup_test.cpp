#include <map>
#include <string>
#include <vector>

#include "wavecurve/io/files/write_file.hpp"

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

/// What LaTeX would stop at: braces and environments that are not closed in their order, a dollar sign
/// without its second in one cell, a row with more or fewer cells than the first. Comments and escaped
/// signs aside.
std::string faults_of_latex(const std::string& latex) {
  std::vector<std::string> open;
  int cells = 0, cells_of_head = 0;
  bool in_math = false;
  for (std::size_t i = 0; i < latex.size(); ++i) {
    const std::string_view rest = std::string_view(latex).substr(i);
    if (rest.starts_with('%')) {
      i = latex.find('\n', i);
    } else if (rest.starts_with("\\begin{") || rest.starts_with("\\end{")) {
      const std::size_t name = latex.find('{', i) + 1, end = latex.find('}', i);
      const std::string environment = latex.substr(name, end - name);
      if (rest.starts_with("\\begin{")) {
        open.push_back(environment);
      } else {
        if (open.empty() || open.back() != environment) return "ends " + environment;
        open.pop_back();
      }
      i = end;
    } else if (rest.starts_with("\\\\")) {
      if (cells > 0 && cells_of_head == 0) cells_of_head = cells;
      if (cells > 0 && cells != cells_of_head) return "a row of " + std::to_string(cells);
      cells = 0;
      ++i;
    } else if (rest.front() == '\\') {
      ++i;
    } else if (rest.front() == '{') {
      open.emplace_back("{");
    } else if (rest.front() == '}') {
      if (open.empty() || open.back() != "{") return "a brace closes " + std::to_string(i);
      open.pop_back();
    } else if (rest.front() == '&') {
      if (in_math) return "a dollar sign is open";
      ++cells;
    } else if (rest.front() == '$') {
      in_math = !in_math;
    } else if (rest.front() == '#' || rest.front() == '_' || rest.front() == '^') {
      return "a sign of LaTeX's own: " + std::string(rest.substr(0, 20));
    }
  }
  return open.empty() && !in_math ? "" : "left open";
}

/// Every row of a pipe table has as many bars that are not escaped as the first.
bool is_markdown_table(const std::string& markdown) {
  std::map<int, int> rows;
  std::size_t begin = 0;
  while (begin < markdown.size()) {
    const std::size_t end = markdown.find('\n', begin);
    int bars = 0;
    for (std::size_t i = begin; i < end; ++i) {
      if (markdown[i] == '\\')
        ++i;
      else if (markdown[i] == '|')
        ++bars;
    }
    if (markdown[begin] == '|') ++rows[bars];
    begin = end + 1;
  }
  return rows.size() == 1 && rows.begin()->second > 2;
}

class MarkupFormats : public ProgramTest {
 protected:
  std::string out(const std::string& arguments) const { return wavecurve(arguments).out; }

  void expect_tables(const std::string& arguments) const {
    const std::string latex = out(arguments + " --format latex");
    EXPECT_NE(latex.find("\\toprule"), std::string::npos) << arguments << latex;
    EXPECT_EQ(faults_of_latex(latex), "") << arguments << "\n" << latex;
    const std::string markdown = out(arguments + " --format markdown");
    EXPECT_TRUE(is_markdown_table(markdown)) << arguments << "\n" << markdown;
  }
};

TEST_F(MarkupFormats, TheTestsSeeFaults) {
  EXPECT_EQ(faults_of_latex("\\begin{a}{x & \\& \\\\ 1 & 2 \\\\}\\end{a}% }\n"), "");
  for (const char* broken : {"{", "}", "\\begin{a}", "\\begin{a}{\\end{a}}",
                             "a & b \\\\ c & d & e \\\\", "a_b", "$ & $", "$"}) {
    EXPECT_NE(faults_of_latex(broken), "") << broken;
  }
  EXPECT_FALSE(is_markdown_table("| a | b |\n| a | b | c |\n"));
}

TEST_F(MarkupFormats, EveryCommandWritesThem) {
  expect_tables("filter D4");
  expect_tables("filter bior4.4 --digits 12");
  expect_tables("filter db30");
  expect_tables("coefficients D8");
  expect_tables("coefficients db3 --quantity \"int(phi'', phi)\"");
  expect_tables("check '" WAVECURVE_SOURCE_DIR "/verification/published/table_1.csv'");
  expect_tables("check '" WAVECURVE_SOURCE_DIR "/verification/published/table_2.csv'");
  io::write_file(folder_ / "list", "0.4829629131 0.8365163037 0.2241438680 -0.1294095226\n");
  expect_tables("identify list");
}

TEST_F(MarkupFormats, FiltersAreSideBySide) {
  EXPECT_EQ(out("filter D4 --digits 5 --format latex"),
            "% \\usepackage{booktabs, siunitx}\n"
            "\\begin{table}\n"
            "  \\centering\n"
            "  \\caption{Filter db2}\n"
            "  \\begin{tabular}{S[table-format=-1] S[table-format=-1.5] S[table-format=-1.5]}\n"
            "    \\toprule\n"
            "    {index} & {analysis low} & {analysis high} \\\\\n"
            "    \\midrule\n"
            "    -2 &  & -0.12941 \\\\\n"
            "    -1 &  & -0.22414 \\\\\n"
            "    0 & 0.48296 & 0.83652 \\\\\n"
            "    1 & 0.83652 & -0.48296 \\\\\n"
            "    2 & 0.22414 &  \\\\\n"
            "    3 & -0.12941 &  \\\\\n"
            "    \\bottomrule\n"
            "  \\end{tabular}\n"
            "  \\par\\smallskip{\\footnotesize The synthesis filters are the same.\\par}\n"
            "\\end{table}\n");
}

TEST_F(MarkupFormats, CoefficientsSayHowAccurateTheyAre) {
  const std::string markdown = out("coefficients D8 --digits 6 --format markdown");
  EXPECT_NE(markdown.find("| index | alpha | mu | nu |\n| ---: | ---: | ---: | ---: |\n"
                          "| 0 | 2.00000 | 4.16597 | 29.1618 |\n"),
            std::string::npos)
      << markdown;
  EXPECT_NE(markdown.find("- alpha: every value is within 1e-6 of the true one\n"),
            std::string::npos)
      << markdown;
  EXPECT_NE(
      out("coefficients D8 --digits 12 --format markdown").find("- alpha: every value is exact\n"),
      std::string::npos);
}

TEST_F(MarkupFormats, WrongDigitsAreMarked) {
  io::write_file(folder_ / "t.csv",
                 "# filter: D8\n# quantity: h\nindex,printed\n"
                 "0,0.23037781\n1,-0.71484657\n2,0.63188077\n3,-0.02798377\n"
                 "4,0.18703481\n5,0.03084138\n6,0.03288301\n7,-0.01059740\n");
  const std::string markdown = out("check t.csv --format markdown");
  for (const char* cell : {"| 0.23037781 |", "| <b>-</b>0.71484657 |", "| 0.63<b>1</b>88077 |"}) {
    EXPECT_NE(markdown.find(cell), std::string::npos) << cell << "\n" << markdown;
  }
  const std::string latex = out("check t.csv --format latex");
  for (const char* cell :
       {" & 0.23037781 & ", " & {$\\underline{-}0.71484657$} & ",
        " & {$0.63\\underline{1}88077$} & ", " & {$\\underline{\\phantom{-}}0.18703481$} & "}) {
    EXPECT_NE(latex.find(cell), std::string::npos) << cell << "\n" << latex;
  }
}

TEST_F(MarkupFormats, SpecialCharactersAreEscaped) {
  io::write_file(folder_ / "t.csv",
                 "# title: 100% of $x_1^2$ & {#|~<\\>} [*] -- `a` −½\n# filter: D4\n# quantity: h\n"
                 "index,printed,no_te\n0,0.48296291,a|b \\ [c] {\n1,\"$0.8365163$\",*\n");
  expect_tables("check t.csv");
  const std::string latex = out("check t.csv --format latex");
  EXPECT_NE(latex.find("\\caption{100\\% of \\$x\\_1\\textasciicircum{}2\\$ \\& "
                       "\\{\\#\\textbar{}\\textasciitilde{}\\textless{}\\textbackslash{}"
                       "\\textgreater{}\\} {[}{*}{]} -{}- `a` $-$$\\frac{1}{2}$}"),
            std::string::npos)
      << latex;
  EXPECT_NE(latex.find(" & 0.8365163 & "), std::string::npos) << "numbers are plain decimals";
  const std::string markdown = out("check t.csv --format markdown");
  EXPECT_NE(markdown.find("a\\|b \\\\ \\[c\\] {"), std::string::npos) << markdown;
  EXPECT_NE(markdown.find("\\$0.8365163\\$"), std::string::npos) << markdown;
}

TEST_F(MarkupFormats, ALongTableBreaksAcrossPages) {
  EXPECT_NE(out("filter db30 --format latex").find("\\begin{longtable}"), std::string::npos);
  EXPECT_EQ(out("filter db4 --format latex").find("longtable"), std::string::npos);
}

}  // namespace
}  // namespace wavecurve::tools
