#include "sdp_answer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <initializer_list>
#include <sstream>
#include <string_view>

namespace isostretch::baselines {
namespace {

// A piece of what a program prints at its end, and what that means.
struct Phrase {
  std::string_view text;
  Status status;
};

std::string trimmed(const std::string& line) {
  const auto first = line.find_first_not_of(" \t\r"), last = line.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : line.substr(first, last - first + 1);
}

// By the first phrase of the list that the text has; its line is the message.
void judge(const std::string& text, std::initializer_list<Phrase> phrases, SdpAnswer& answer) {
  for (const Phrase& phrase : phrases) {
    const auto place = text.find(phrase.text);
    if (place == std::string::npos) continue;
    const auto before = text.rfind('\n', place), start = before == std::string::npos ? 0 : before + 1;
    answer.status = phrase.status;
    answer.message = trimmed(text.substr(start, text.find('\n', place) - start));
    return;
  }
}

// The number that begins the text after blanks; 0 where there is none.
int count_at(std::string_view text) {
  int count = 0;
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  std::from_chars(text.data(), text.data() + text.size(), count);
  return count;
}

// What follows the last occurrence of a word.
std::string_view after_last(std::string_view text, std::string_view word) {
  const auto place = text.rfind(word);
  return place == std::string_view::npos ? std::string_view() : text.substr(place + word.size());
}

// All of the numbers at the beginning, with blanks or commas between.
std::vector<double> leading_numbers(std::string_view text) {
  std::vector<double> numbers;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(" ,+"), text.size()));
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc()) return numbers;
    numbers.push_back(value);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
}

std::string_view first_line(std::string_view text) {
  return text.substr(0, text.find('\n'));
}

}  // namespace

// Our problem is what CSDP calls the dual. That its primal were infeasible would mean that ours had no
// minimum, which is wrong of every instance.
SdpAnswer read_csdp(const std::string& output, const std::string& answer) {
  SdpAnswer result;
  judge(output,
        {{"Success: SDP solved", Status::converged},
         {"SDP is dual infeasible", Status::claims_infeasible},
         {"SDP is primal infeasible", Status::failed},
         {"Partial Success", Status::stalled},
         {"Maximum iterations reached", Status::iteration_limit},
         {"Stuck at edge", Status::stalled},
         {"Lack of progress", Status::stalled},
         {"line search failures", Status::stalled},
         {"Factorization of the system matrix failed", Status::stalled},
         {"llocation failed", Status::memory_limit},
         {"llocation Failed", Status::memory_limit},
         {"Failure: return code", Status::failed}},
        result);
  result.iterations = count_at(after_last(output, "Iter:"));
  result.v = leading_numbers(first_line(answer));
  return result;
}

// Ours is SDPA's primal (P). Verdicts without INF, OPT or UNBD: it stopped, with or without feasible points.
SdpAnswer read_sdpa(const std::string&, const std::string& answer) {
  SdpAnswer result;
  judge(answer,
        {{"= pdOPT", Status::converged},
         {"= pINF_dFEAS", Status::claims_infeasible},
         {"= pdINF", Status::claims_infeasible},
         {"= dUNBD", Status::claims_infeasible},
         {"= pFEAS_dINF", Status::failed},
         {"= pUNBD", Status::failed},
         {"phase.value", Status::stalled}},
        result);
  const auto count = [&](std::string_view word) { return count_at(after_last(answer, word)); };
  result.iterations = count("   Iteration =");
  if (result.status == Status::stalled && result.iterations >= count("maxIteration ="))
    result.status = Status::iteration_limit;
  const std::string_view x = after_last(answer, "xVec =");
  result.v = leading_numbers(x.substr(std::min(x.find('{') + 1, x.size())));
  return result;
}

// Ours is what DSDP calls the dual.
SdpAnswer read_dsdp(const std::string& output, const std::string& answer) {
  SdpAnswer result;
  judge(output,
        {{"Dual Infeasible", Status::claims_infeasible},  // it says that it converged besides
         {"Dual Unbounded", Status::failed},
         {"DSDP Converged", Status::converged},
         {"Maximum Number of Iterations", Status::iteration_limit},
         {"DSDP Terminated", Status::stalled},
         {"insufficient memory", Status::memory_limit}},
        result);
  // The last row of the table, which ends where the verdict stands or with a blank line.
  const std::string_view table = after_last(output, "Pnrm\n");
  std::istringstream rows{std::string(table.substr(std::min(table.find('\n') + 1, table.size())))};
  for (std::string row; std::getline(rows, row) && !row.empty() && row[0] >= '0' && row[0] <= '9';)
    result.iterations = count_at(row);
  result.v = leading_numbers(first_line(answer));
  return result;
}

std::string last_line(const std::string& text) {
  std::istringstream lines(text);
  std::string last;
  for (std::string line; std::getline(lines, line);)
    if (std::string shown = trimmed(line); !shown.empty()) last = std::move(shown);
  return last;
}

bool speaks_of_memory(const std::string& text) {
  constexpr std::array<std::string_view, 7> words = {
      "bad_alloc",    "llocation failed",      "llocation Failed", "insufficient memory",
      "ut of memory", "annot allocate memory", "memory exhausted"};
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return text.find(word) != std::string::npos; });
}

}  // namespace isostretch::baselines
