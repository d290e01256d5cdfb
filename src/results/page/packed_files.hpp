#pragma once

// The packed sources define what this header declares; cmake/PackFiles.cmake includes it by this name.
#include "coilwright/results/page/page_file.hpp"

namespace coilwright::results {

using text::PackedFile;

}  // namespace coilwright::results
