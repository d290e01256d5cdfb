#pragma once

#include <filesystem>
#include <span>

namespace coilwright::cli {

/// Throws text::OutputError naming the first of `outputs` that is one of `inputs`: writing it would lose it.
void keep_inputs(std::span<const std::filesystem::path> inputs, std::span<const std::filesystem::path> outputs);

}  // namespace coilwright::cli
