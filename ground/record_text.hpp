#pragma once
/// Lines and numbers of records. Internal to ground/.

#include "ground/record.hpp"
#include "ground/record_error.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ground {

struct RecordText {
    std::string path;
    std::vector<std::string_view> lines; ///< without line ends
};

[[nodiscard]] RecordText lines_of(const std::string& path, std::string_view text);

/// @param line index, from 0
[[noreturn]] void refuse(const RecordText& text, std::size_t line, const std::string& why);

[[nodiscard]] std::string_view stripped(std::string_view text);
[[nodiscard]] std::string lower(std::string_view text);
[[nodiscard]] std::string in_quotes(std::string_view text);
/// With six digits at most.
[[nodiscard]] std::string shown(double x);

/// A whole text as one finite number; nothing if it is none.
[[nodiscard]] std::optional<double> number_of(std::string_view text);

/// The first number behind `key`, whatever the case; blanks, '=' and ':' may stand between.
[[nodiscard]] std::optional<double> number_after(std::string_view line, std::string_view key);

/// Index of the first line in [from, from + many) that has `word`, whatever the case;
/// lines.size() if there is none.
[[nodiscard]] std::size_t find_line(const RecordText& text, std::string_view word,
                                    std::size_t from = 0, std::size_t many = 100);

/// The texts of the numbers of a line. Of width 0 they are divided by blanks, commas,
/// semicolons, quotes, or by the sign of the next one.
[[nodiscard]] std::vector<std::string_view> fields(std::string_view line, std::size_t width);

/// True if there is at least one field and each is a number, NaN and infinity included.
[[nodiscard]] bool all_numbers(std::string_view line);

/// Numbers that follow each other over lines.
struct Values {
    std::vector<double> values;
    std::size_t end = 0; ///< index of the line behind the last of them
};

/// @param count as many as the head states
/// @param width of a field in characters, 0: fields(.., 0)
/// @throws RecordError if there are fewer, or a field is no finite number
[[nodiscard]] Values read_values(const RecordText& text, std::size_t from, std::size_t count,
                                 std::size_t width);

/// A number of samples or a time step that a head states.
/// @throws RecordError
[[nodiscard]] std::size_t checked_count(const RecordText& text, std::size_t line,
                                        std::optional<double> count);
[[nodiscard]] double checked_step(const RecordText& text, std::size_t line,
                                  std::optional<double> step);

/// Values in `unit` as a record. The options' unit takes its place.
/// @param unit as the file has it
/// @param line index of the first value
[[nodiscard]] Record record_of(const RecordText& text, const ReadOptions& options,
                               std::string_view format, std::string_view unit, std::size_t line,
                               double step, std::vector<double> values);

/// Refuses a peak that is not the one stated, beyond its rounding.
/// @param head index of the line that states it
/// @param stated [unit of the head], `unit` its value [m/s2]
void check_peak(const RecordText& text, std::size_t head, Record& record, double stated,
                double unit);

/// Refuses a step that does not make the duration [s] which the head states: the peak, which
/// is compared too, stays what it is with a wrong step.
/// @param head index of the line that states it
/// @param tolerance share of the duration, beside two steps
void check_duration(const RecordText& text, std::size_t head, std::optional<double> stated,
                    std::size_t count, double step, double tolerance = 0.01);

[[nodiscard]] std::vector<Record> at2_records(const RecordText&, const ReadOptions&);
[[nodiscard]] std::vector<Record> column_records(const RecordText&, const ReadOptions&);
[[nodiscard]] std::vector<Record> v1_records(const RecordText&, const ReadOptions&);
[[nodiscard]] std::vector<Record> v2_records(const RecordText&, const ReadOptions&);
[[nodiscard]] std::vector<Record> v2a_records(const RecordText&, const ReadOptions&);
[[nodiscard]] std::vector<Record> smc_records(const RecordText&, const ReadOptions&);
[[nodiscard]] std::vector<Record> esm_records(const RecordText&, const ReadOptions&);
[[nodiscard]] std::vector<Record> knet_records(const RecordText&, const ReadOptions&);
[[nodiscard]] std::vector<Record> cosmos_records(const RecordText&, const ReadOptions&);
[[nodiscard]] std::vector<Record> usgs_records(const RecordText&, const ReadOptions&);

/// Times and values in turn, to equal steps.
/// @param line of each time, index
/// @param decimals of the times as written
/// @throws RecordError at the time that is out of step
[[nodiscard]] double common_step(const RecordText& text, const std::vector<double>& time,
                                 const std::vector<std::size_t>& line, int decimals);

} // namespace ground
