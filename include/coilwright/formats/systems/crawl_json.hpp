#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/systems/crawl.hpp"
#include "coilwright/systems/crawl_heat.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// Every number of a crawl that `crawl` prints by its key, which ends in its unit; nothing for a time that never comes.
using CrawlRows = std::vector<std::pair<std::string, std::optional<double>>>;
[[nodiscard]] CrawlRows rows_of(const systems::Crawler& crawler, const systems::Crawl& crawl,
                                const systems::CrawlHeat& heat);

/// The same as `crawl --json` prints it.
[[nodiscard]] text::Json to_json(const CrawlRows& rows);

}  // namespace coilwright::formats
