/// \file
/// Records as columns, and back: each column of a recording is described once, in recording_columns.hpp, and written,
/// read and named from there.
#pragma once

#include "io/columns.hpp"

#include <carom/error.hpp>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

namespace carom::io {

/// The number that stands for a field in a file.
template <class Field>
auto stored(const Field& field)
{
    if constexpr (std::is_enum_v<Field> || std::is_same_v<Field, bool>)
        return static_cast<std::uint8_t>(field);
    else if constexpr (std::is_same_v<Field, std::optional<double>>)
        return field.value_or(std::numeric_limits<double>::quiet_NaN());
    else
        return field;
}

template <class Value, class Field>
void restore(Value value, Field& field)
{
    if constexpr (std::is_same_v<Field, bool>)
        field = value != 0;
    else if constexpr (std::is_same_v<Field, std::optional<double>>)
        field = std::isnan(value) ? std::nullopt : std::optional(value);
    else
        field = static_cast<Field>(value);
}

/// Values of a byte that mean something.
struct MeaningfulBytes {
    std::uint8_t least = 0, most = 255;
    const char* otherwise = "";  ///< what a file is that has others
};

/// \tparam Access (record, lane) -> reference to a field
template <std::size_t Lanes, class Access>
struct Column {
    std::string_view name;
    Access field;
    bool differences = false;  ///< from row to row are stored
    MeaningfulBytes bytes{};

    static constexpr std::size_t lanes = Lanes;
    template <class Record>
    using Value = decltype(stored(std::declval<Access>()(std::declval<const Record&>(), std::size_t{0})));

    constexpr Column by_differences() const { return {name, field, true, bytes}; }
    constexpr Column within(std::uint8_t least, std::uint8_t most, const char* otherwise) const
    {
        return {name, field, differences, {least, most, otherwise}};
    }
};

template <std::size_t Lanes, class Access>
constexpr Column<Lanes, Access> lanes(std::string_view name, Access field)
{
    return {name, field};
}
template <class Access>
constexpr auto column(std::string_view name, Access field)
{
    return lanes<1>(
        name, [field](auto& record, std::size_t) -> auto& { return field(record); });
}

template <class Record, class Column>
void pack_column(ColumnWriter& out, const Column& column, std::span<const Record> rows)
{
    using Value = typename Column::template Value<Record>;
    std::vector<Value> values(rows.size());
    for (std::size_t lane = 0; lane < Column::lanes; ++lane) {
        for (std::size_t i = 0; i < rows.size(); ++i) values[i] = stored(column.field(rows[i], lane));
        if constexpr (std::is_same_v<Value, std::int64_t>)
            if (column.differences) {
                out.add_differences(values);
                continue;
            }
        out.add(values);
    }
}

template <class Record, class Column>
void unpack_column(ColumnReader& in, const Column& column, std::vector<Record>& rows, const std::string& file)
{
    using Value = typename Column::template Value<Record>;
    std::vector<Value> values;
    for (std::size_t lane = 0; lane < Column::lanes; ++lane) {
        bool read = false;
        if constexpr (std::is_same_v<Value, std::int64_t>)
            if ((read = column.differences)) in.read_differences(values);
        if (!read) in.read(values);
        if constexpr (std::is_same_v<Value, std::uint8_t>)
            for (const Value value : values)
                if (value < column.bytes.least || value > column.bytes.most)
                    throw InputError({file + ": damaged: " + column.bytes.otherwise});
        for (std::size_t i = 0; i < rows.size(); ++i) restore(values[i], column.field(rows[i], lane));
    }
}

template <class Record, class... Columns>
Bytes pack(const std::tuple<Columns...>& columns, std::span<const Record> rows)
{
    ColumnWriter out;
    std::apply([&](const auto&... each) { (pack_column(out, each, rows), ...); }, columns);
    return out.bytes();
}

/// \throws InputError if the bytes are no such columns, or a value has no meaning
template <class Record, class... Columns>
std::vector<Record> unpack(const std::tuple<Columns...>& columns, std::span<const unsigned char> data,
                           std::size_t count, const std::string& file)
{
    std::vector<Record> rows(count);
    ColumnReader in(data, count, file);
    std::apply([&](const auto&... each) { (unpack_column(in, each, rows, file), ...); }, columns);
    in.finish();
    return rows;
}

/// "kind u8, epoch d i64, normal 3 f64": the columns as docs/recording.md names them.
template <class Record, class... Columns>
std::string columns_text(const std::tuple<Columns...>& columns)
{
    std::string text;
    const auto add = [&](const auto& each) {
        using Column = std::decay_t<decltype(each)>;
        using Value = typename Column::template Value<Record>;
        constexpr const char* type = std::is_floating_point_v<Value> ? "f" : std::is_signed_v<Value> ? "i" : "u";
        text += (text.empty() ? "" : ", ") + std::string(each.name) + (each.differences ? " d" : "") +
                (Column::lanes > 1 ? " " + std::to_string(Column::lanes) : "") + " " + type +
                std::to_string(8 * sizeof(Value));
    };
    std::apply([&](const auto&... each) { (add(each), ...); }, columns);
    return text;
}

}  // namespace carom::io
