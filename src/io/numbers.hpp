/// \file
/// Numbers as text that reads back as the same number.
#pragma once

#include <carom/event.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace carom::io {

/// Shortest decimal that is the same double; empty for what is not finite, for files never say "nan".
std::string number_text(double value);
std::string number_text(const std::optional<double>& value);

/// Length of an epoch, a power of two, as the two times of an event imply it [time]. 1 in epoch 0, where it does not
/// matter.
double implied_epoch_length(const Event& event);

/// epoch * epoch_length + offset without rounding: the shortest decimal if the sum is a double, all digits otherwise.
/// \pre epoch >= 0, epoch_length a power of two, 0 <= offset finite
std::string exact_time_text(const EpochTime& at, double epoch_length);

/// A CSV field; quoted (RFC 4180) where it has a comma, a quote or a line break.
std::string csv_field(std::string_view text);

}  // namespace carom::io
