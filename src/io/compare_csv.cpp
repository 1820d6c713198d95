#include "io/compare_files.hpp"
#include "io/numbers.hpp"
#include "study/compare_columns.hpp"

namespace carom::io {

namespace {

struct CellText {
    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(std::optional<double> value) const { return number_text(value); }
    std::string operator()(std::optional<std::int64_t> value) const { return value ? std::to_string(*value) : ""; }
};

std::string line(const CompareRow& row)
{
    std::string text;
    for (const study::CompareColumn& column : study::compare_columns)
        text += std::visit(CellText{}, column.cell(row)) + ",";
    text.pop_back();
    return text;
}

}  // namespace

std::string compare_csv_header()
{
    std::string text;
    for (const study::CompareColumn& column : study::compare_columns) text += std::string(column.name) + ",";
    text.pop_back();
    return text;
}

std::string compare_csv(const Comparison& comparison)
{
    std::string text = compare_csv_header() + "\n";
    for (const CompareRow& row : comparison.rows) text += line(row) + "\n";
    return text;
}

}  // namespace carom::io
