/// \file
/// The files that pages are made of.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace carom::cli {

/// Beside compare.json: what the page draws of that comparison.
inline constexpr const char* page_data_file = "page.json";

/// "carom 0.1.0", as pages name who wrote them.
std::string page_generator();

/// One self-contained page of these comparisons (`report::comparison_data`). \throws InputError if it cannot be written
void write_page(const std::filesystem::path& file, const std::vector<std::string>& comparisons);

}  // namespace carom::cli
