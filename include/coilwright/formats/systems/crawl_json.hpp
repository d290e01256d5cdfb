#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/systems/crawl.hpp"
#include "coilwright/systems/crawl_heat.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// Every number that `crawl` prints, by its key, which ends in its unit; absent for a time that never comes.
using CrawlRows = std::vector<std::pair<std::string, std::optional<double>>>;
[[nodiscard]] CrawlRows rows_of(const systems::Crawler& crawler, const systems::Crawl& crawl,
                                const systems::CrawlHeat& heat);

/// Those numbers as `crawl --json` prints them.
[[nodiscard]] text::Json to_json(const CrawlRows& rows);

}  // namespace coilwright::formats
