#include "coilwright/text/spelling.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

#include "coilwright/text/one_line.hpp"

namespace coilwright::text {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  // Rows of the dynamic programme: two letters back (for swaps), one letter back, and the present one.
  std::vector<std::size_t> before(b.size() + 1), previous(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) previous[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, previous[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(previous);
    previous.swap(row);
  }
  return previous[b.size()];
}

bool is_one_of(std::string_view word, std::string_view words) {
  for (std::size_t at = 0; at <= words.size();) {
    const std::size_t end = std::min(words.find('|', at), words.size());
    if (words.substr(at, end - at) == word) return true;
    at = end + 1;
  }
  return false;
}

std::vector<std::string> nearest_words(std::string_view word, std::span<const std::string> candidates) {
  constexpr std::size_t longest_word = 100;  // what is longer is no slip of ours, and the distance costs a * b
  if (word.size() > longest_word) return {};
  std::size_t best_distance = std::max<std::size_t>(1, word.size() / 3);
  std::vector<std::string> best;
  for (const std::string& candidate : candidates) {
    if (candidate.size() > longest_word || candidate == word) continue;
    const std::size_t distance = edit_distance(word, candidate);
    if (distance > best_distance || distance >= word.size()) continue;  // a single letter is no slip for another one
    if (distance < best_distance) best.clear();
    best_distance = distance;
    best.push_back(candidate);
  }
  return best;
}

namespace {

// More are no hint.
constexpr std::size_t most_words = 4;

// None where `word` is too short to tell anything, and where more candidates match than a message may list.
template <typename Matches>
std::vector<std::string> matching_words(std::string_view word, std::span<const std::string> candidates,
                                        const Matches& matches) {
  constexpr std::ptrdiff_t fewest_letters = 2;
  const auto is_letter = [](unsigned char letter) { return letter != '-' && letter != '_'; };
  if (std::ranges::count_if(word, is_letter) < fewest_letters) return {};
  std::vector<std::string> words;
  for (const std::string& candidate : candidates)
    if (candidate != word && matches(candidate)) words.push_back(candidate);
  if (words.size() > most_words) words.clear();
  return words;
}

// "_supply_voltage_V_" of "--supply-voltage-V": each of its words is whole between two of these.
std::string between_underscores(std::string_view name) {
  const std::size_t first = name.find_first_not_of('-');
  std::string out = fmt::format("_{}_", first == std::string_view::npos ? "" : name.substr(first));
  std::ranges::replace(out, '-', '_');
  return out;
}

}  // namespace

std::string must_be_one_of(std::span<const std::string> legal) {
  std::vector<std::string> shown;
  for (const std::string& word : legal) shown.push_back(in_quotes(word));
  return fmt::format("must be {}{}", legal.size() == 1 ? "" : "one of ", fmt::join(shown, ", "));
}

std::string radius_or_diameter(std::string_view word, std::span<const std::string> candidates) {
  constexpr std::string_view radius = "radius", diameter = "diameter";
  for (const auto& [said, meant, relation] :
       {std::tuple(diameter, radius, "half of the diameter"), std::tuple(radius, diameter, "twice the radius")}) {
    const std::size_t at = word.find(said);
    if (at == std::string_view::npos) continue;
    const std::string other = fmt::format("{}{}{}", word.substr(0, at), meant, word.substr(at + said.size()));
    for (const std::string& each : candidates)
      if (each.starts_with(other)) return fmt::format("; did you mean {}, {}?", in_quotes(each), relation);
  }
  return {};
}

std::string did_you_mean(std::string_view word, std::span<const std::string> candidates) {
  const auto begins = [&](const std::string& each) { return each.starts_with(word); };
  const auto has = [&, inside = between_underscores(word)](const std::string& each) {
    return begins(each) || between_underscores(each).find(inside) != std::string::npos;
  };
  std::vector<std::string> words = matching_words(word, candidates, has);
  if (words.empty())
    if (std::string other = radius_or_diameter(word, candidates); !other.empty()) return other;
  if (words.empty()) words = matching_words(word, candidates, begins);
  if (words.empty()) words = nearest_words(word, candidates);
  if (words.empty() || words.size() > most_words) return {};
  for (std::string& meant : words) meant = in_quotes(meant);
  const std::string last = words.back();
  words.pop_back();
  if (words.empty()) return "; did you mean " + last + "?";
  return fmt::format("; did you mean {} or {}?", fmt::join(words, ", "), last);
}

}  // namespace coilwright::text
