#include "page/sweep_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "coilwright/text/csv/csv_texts.hpp"
#include "coilwright/text/input_error.hpp"

namespace coilwright::page {
namespace {

constexpr double most_samples = 3000.0;
constexpr std::size_t most_reasons = 20;
constexpr std::size_t most_cells = 2500;  // of a map

// A number below 1 for each row, without any pattern that the grid could fall in with (splitmix64, Steele 2014).
double share_of(std::uint64_t row) {
  std::uint64_t mixed = (row + 1) * 0x9E3779B97F4A7C15ULL;
  mixed = (mixed ^ (mixed >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  mixed = (mixed ^ (mixed >> 27U)) * 0x94D049BB133111EBULL;
  return static_cast<double>((mixed ^ (mixed >> 31U)) >> 11U) * 0x1.0p-53;
}

// Where the columns of a row lie among those that are read.
struct Places {
  std::vector<std::size_t> variables;
  std::vector<std::size_t> objectives;
  std::vector<std::size_t> margins;
  std::size_t status{};
  std::size_t reason{};
  std::optional<std::size_t> configuration;
};

bool all_there(const std::vector<std::optional<double>>& values) {
  return std::ranges::all_of(values, [](const auto& each) { return each.has_value(); });
}

class Summary {
 public:
  Summary(const FrontTable& leaders, Places places, std::size_t designs, bool sampled, std::string file)
      : leaders_(&leaders),
        places_(std::move(places)),
        keep_(most_samples / static_cast<double>(designs)),
        file_(std::move(file)) {
    table_.variables = leaders.variables;
    table_.sampled = sampled;
    table_.best.resize(table_.variables.size());
    table_.values.resize(table_.variables.size());
    known_.resize(table_.variables.size());
    for (std::size_t up = 1; up < table_.variables.size() && !sampled; ++up)
      for (std::size_t across = 0; across < up; ++across) table_.maps.push_back({.across = across, .up = up});
    for (const std::string& name : leaders.margins) table_.broken.push_back({.margin = name});
  }

  void add(std::span<const std::string_view> fields, std::size_t line) {
    line_ = line;
    const std::string_view status = fields[places_.status];
    std::vector<std::optional<double>> objectives;
    if (status == "failed") {
      count_failure(std::string(fields[places_.reason]));
    } else {
      for (std::size_t i = 0; i < places_.objectives.size(); ++i)
        objectives.push_back(number(fields[places_.objectives[i]], leaders_->objectives[i]));
      if (status == "ok") improve(fields, objectives);
      count_broken(fields);
      if (share_of(table_.rows) < keep_) sample(fields, status == "ok", objectives);
    }
    draw(fields, status == "ok" && all_there(objectives) ? objectives : std::vector<std::optional<double>>());
    ++table_.rows;
  }

  [[nodiscard]] SweepTable table() && {
    std::erase_if(table_.maps, [&](const SweepTable::Map& map) {
      return table_.values[map.across].size() < 2 || table_.values[map.up].size() < 2;
    });
    return std::move(table_);
  }

 private:
  [[nodiscard]] std::optional<double> number(std::string_view field, const std::string& column) const {
    return text::number_or_nothing(field, file_, line_, column);
  }

  void count_failure(std::string reason) {
    const bool known = table_.failures.contains(reason) || table_.failures.size() < most_reasons;
    ++table_.failures[known ? std::move(reason) : std::string("other reasons")];
  }

  void improve(std::span<const std::string_view> fields, const std::vector<std::optional<double>>& objectives) {
    if (!all_there(objectives)) return;
    const std::string group = places_.configuration ? std::string(fields[*places_.configuration]) : std::string();
    for (std::size_t v = 0; v < places_.variables.size(); ++v) {
      std::vector<SweepTable::Best>& groups = table_.best[v];
      auto found = std::ranges::find(groups, group, &SweepTable::Best::group);
      if (found == groups.end()) found = groups.insert(found, {.group = group});
      take_best(found->rows[std::string(fields[places_.variables[v]])], objectives);
    }
  }

  void take_best(std::vector<double>& best, const std::vector<std::optional<double>>& objectives) const {
    for (std::size_t i = 0; i < objectives.size(); ++i) {
      if (best.size() <= i)
        best.push_back(*objectives[i]);
      else
        best[i] = leaders_->largest[i] ? std::max(best[i], *objectives[i]) : std::min(best[i], *objectives[i]);
    }
  }

  // The place of a value among those of its variable. Of more than a map may have it is no matter: no map has them.
  std::size_t place_of(std::size_t variable, std::string_view field) {
    const auto found = known_[variable].find(field);
    if (found != known_[variable].end()) return found->second;
    const std::size_t place = known_[variable].size();
    if (place > most_cells) return place;
    known_[variable].emplace(field, place);
    table_.values[variable].emplace_back(field);
    return place;
  }

  // A cell is there as soon as a design is; `objectives` is empty for one that does not keep every limit.
  void draw(std::span<const std::string_view> fields, const std::vector<std::optional<double>>& objectives) {
    std::vector<std::size_t> at;
    for (std::size_t v = 0; v < places_.variables.size() && !table_.sampled; ++v)
      at.push_back(place_of(v, fields[places_.variables[v]]));
    for (SweepTable::Map& map : table_.maps) {
      if (table_.rows > 0 && map.cells.empty()) continue;  // too many
      take_best(map.cells[{at[map.across], at[map.up]}], objectives);
      if (map.cells.size() > most_cells) map.cells.clear();
    }
  }

  void count_broken(std::span<const std::string_view> fields) {
    std::vector<std::size_t> broken;
    for (std::size_t i = 0; i < places_.margins.size(); ++i)
      if (const auto margin = number(fields[places_.margins[i]], leaders_->margins[i]); margin && *margin < 0.0)
        broken.push_back(i);
    for (const std::size_t i : broken) {
      ++table_.broken[i].times;
      if (broken.size() == 1) ++table_.broken[i].alone;
    }
  }

  void sample(std::span<const std::string_view> fields, bool keeps_limits,
              std::vector<std::optional<double>> objectives) {
    SweepTable::Sample out{.keeps_limits = keeps_limits, .variables = {}, .objectives = std::move(objectives)};
    for (const std::size_t place : places_.variables) out.variables.emplace_back(fields[place]);
    table_.samples.push_back(std::move(out));
  }

  const FrontTable* leaders_;
  Places places_;
  double keep_;
  std::string file_;
  std::size_t line_{};
  std::vector<std::map<std::string, std::size_t, std::less<>>> known_;  // places of the values of each variable
  SweepTable table_;
};

// The columns that are kept come in the order of the file: that of best.csv.
Places places_in(const FrontTable& leaders, const std::vector<std::string>& names) {
  Places out;
  const auto place_of = [&](std::string_view name) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) throw leaders.texts.error(fmt::format("must have the column {}", name));
    return static_cast<std::size_t>(found - names.begin());
  };
  for (const std::string& name : leaders.variables) out.variables.push_back(place_of(name));
  for (const std::string& name : leaders.objectives) out.objectives.push_back(place_of(name));
  for (const std::string& name : leaders.margins) out.margins.push_back(place_of(name));
  out.status = place_of("status");
  out.reason = place_of("reason");
  if (std::ranges::find(leaders.variables, "configuration") != leaders.variables.end())
    out.configuration = place_of("configuration");
  return out;
}

}  // namespace

SweepTable read_sweep(const std::filesystem::path& folder, const FrontTable& leaders, std::size_t designs,
                      bool sampled) {
  const auto is_kept = [&](std::string_view name) {
    const auto among = [&](const std::vector<std::string>& names) {
      return std::ranges::find(names, name) != names.end();
    };
    return name == "status" || name == "reason" || among(leaders.variables) || among(leaders.objectives) ||
           among(leaders.margins);
  };
  std::vector<std::string> names;
  for (const std::string& name : leaders.texts.names())
    if (is_kept(name)) names.push_back(name);
  const std::filesystem::path file = folder / "designs.csv";
  Summary summary(leaders, places_in(leaders, names), designs, sampled, file.string());
  const std::vector<std::string> there =
      text::for_each_csv_row(file, is_kept, [&](std::span<const std::string_view> fields, std::size_t line) {
        if (fields.size() == names.size()) summary.add(fields, line);
      });
  if (there != names) throw text::InputError({.file = file.string(), .rule = "must have the columns of best.csv"});
  SweepTable table = std::move(summary).table();
  if (table.rows != designs)
    throw text::InputError({.file = file.string(),
                            .rule = fmt::format("must have the {} designs that result.json beside it counts", designs),
                            .value = fmt::format("{}", table.rows)});
  return table;
}

}  // namespace coilwright::page
