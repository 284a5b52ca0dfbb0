#include "app/text/csv.hpp"

#include "app/text/config_error.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

namespace app {
namespace {

/// Splits a text into records; what is left to check is whether they fit the head.
class Splitter {
  public:
    Splitter(const std::string& path, std::string_view text, char separator, int first_line)
        : path_(path), text_(text), separator_(separator), line_(first_line)
    {
    }

    std::vector<CsvRow> records()
    {
        std::vector<CsvRow> all;
        while (at_ < text_.size()) {
            CsvRow row{{}, line_};
            const std::size_t start = at_;
            while (cell(row)) {
            }
            const bool blank = std::ranges::all_of(
                row.cells, [](const std::string& c) { return trimmed(c).empty(); });
            const bool quoted = row.cells.size() == 1 && text_[start] == '"';
            if (!blank || quoted) all.push_back(std::move(row));
        }
        return all;
    }

  private:
    /// @return whether the record goes on
    bool cell(CsvRow& row)
    {
        std::string content;
        if (at_ < text_.size() && text_[at_] == '"') {
            content = quoted();
            const std::string_view rest = text_.substr(at_, 2);
            if (!rest.empty() && rest[0] != separator_ && rest[0] != '\n' && rest != "\r\n" &&
                rest != "\r")
                throw ConfigError(path_, line_, "",
                                  "text behind the quote that closes a cell; write a quote "
                                  "inside a cell as \"\"");
        }
        while (at_ < text_.size() && text_[at_] != separator_ && text_[at_] != '\n')
            content += text_[at_++];
        const bool more = at_ < text_.size() && text_[at_] == separator_;
        if (!more && !content.empty() && content.back() == '\r') content.pop_back();
        row.cells.push_back(std::move(content));
        if (at_ < text_.size()) line_ += text_[at_++] == '\n' ? 1 : 0;
        return more;
    }

    std::string quoted()
    {
        const int start = line_;
        std::string content;
        for (++at_; at_ < text_.size(); ++at_) {
            if (text_[at_] == '"' && at_ + 1 < text_.size() && text_[at_ + 1] == '"') {
                ++at_;
            } else if (text_[at_] == '"') {
                ++at_;
                return content;
            }
            line_ += text_[at_] == '\n' ? 1 : 0;
            content += text_[at_];
        }
        throw ConfigError(path_, start, "", "a quoted cell is not closed; add a \" at its end");
    }

    const std::string& path_;
    std::string_view text_;
    char separator_;
    std::size_t at_ = 0;
    int line_;
};

char separator_of(std::string_view text)
{
    text.remove_prefix(std::min(text.size(), text.find_first_not_of("\r\n")));
    const std::string_view head = text.substr(0, text.find('\n'));
    char best = ',';
    std::ptrdiff_t most = 0;
    for (const char c : {',', ';', '\t'}) {
        bool quoted = false;
        std::ptrdiff_t n = 0;
        for (const char h : head) {
            if (h == '"') quoted = !quoted;
            n += h == c && !quoted ? 1 : 0;
        }
        if (n > most) {
            most = n;
            best = c;
        }
    }
    return best;
}

/// Loggers end each line with a separator.
void drop_empty_last_column(std::vector<CsvRow>& rows)
{
    const std::size_t columns = rows.front().cells.size();
    const auto ends_empty = [&](const CsvRow& row) {
        return row.cells.size() == columns && trimmed(row.cells.back()).empty();
    };
    if (columns > 1 && std::ranges::all_of(rows, ends_empty))
        for (CsvRow& row : rows) row.cells.pop_back();
}

void check_head(const std::string& path, const CsvRow& head)
{
    std::set<std::string> names;
    for (std::size_t i = 0; i < head.cells.size(); ++i) {
        const std::string& name = head.cells[i];
        if (name.empty())
            throw ConfigError(path, head.line, "",
                              "column " + std::to_string(i + 1) + " has no name");
        if (!names.insert(name).second)
            throw ConfigError(path, head.line, "",
                              "two columns are called " + in_quotes(name) + "; rename one");
    }
}

} // namespace

std::string_view bare_name(std::string_view head)
{
    const auto open = head.find_first_of("[(");
    return open == 0 ? head : trimmed(head.substr(0, open));
}

std::size_t find_column(const Csv& csv, std::string_view name)
{
    std::vector<std::string_view> names(csv.head.begin(), csv.head.end());
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name) return i;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (bare_name(names[i]) == name) found.push_back(i);
    if (found.size() == 1) return found.front();
    if (found.size() > 1)
        throw ConfigError(csv.path, 0, name, "several columns have this name; add the unit");
    throw ConfigError(csv.path, 0, name, "no such column; " + suggestion(name, names));
}

double signed_number_at(const Csv& csv, const CsvRow& row, std::size_t column)
{
    const auto refuse = [&](const std::string& why) { refuse_cell(csv, row, column, why); };
    std::string text(trimmed(row.cells[column]));
    if (text.empty()) refuse("empty cell; write a number, or take the row out");
    if (csv.separator != ',') std::ranges::replace(text, ',', '.');
    double value = 0.0;
    const char* first = text.data() + (text.front() == '+' ? 1 : 0);
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(first, last, value);
    if (error != std::errc() || end != last)
        refuse(in_quotes(trimmed(row.cells[column])) + " is not a number");
    if (!std::isfinite(value)) refuse(in_quotes(text) + " is not a finite number");
    return value;
}

double number_at(const Csv& csv, const CsvRow& row, std::size_t column)
{
    const double value = signed_number_at(csv, row, column);
    if (value < 0.0)
        refuse_cell(csv, row, column,
                    in_quotes(trimmed(row.cells[column])) +
                        " is negative; it must be at least 0");
    return value;
}

std::string plain_text(std::string text)
{
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
    if (text.find('\n') == std::string::npos) std::ranges::replace(text, '\r', '\n');
    return text;
}

Csv parse_csv(const std::string& path, std::string_view bytes)
{
    const std::string plain = plain_text(std::string(bytes));
    std::string_view text = plain;
    Csv csv;
    csv.path = path;
    int first_line = 1;
    if (text.starts_with("sep=") && text.size() > 4) { // Excel names its separator so
        csv.separator = text[4];
        text.remove_prefix(std::min(text.size(), text.find('\n') + 1));
        first_line = 2;
    } else {
        csv.separator = separator_of(text);
    }
    csv.rows = Splitter(path, text, csv.separator, first_line).records();
    if (csv.rows.empty()) throw ConfigError(path, 0, "", "no head; name the columns in line 1");
    for (std::string& name : csv.rows.front().cells) name = std::string(trimmed(name));
    drop_empty_last_column(csv.rows);
    check_head(path, csv.rows.front());
    csv.head = csv.rows.front().cells;
    csv.rows.erase(csv.rows.begin());
    for (const CsvRow& row : csv.rows)
        if (row.cells.size() != csv.head.size())
            throw ConfigError(path, row.line, "",
                              std::to_string(row.cells.size()) + " cells, but the head has " +
                                  std::to_string(csv.head.size()));
    return csv;
}

void check_rows(const Csv& csv)
{
    if (csv.rows.empty())
        throw ConfigError(csv.path, 0, "",
                          "there is no row below the head; write one for each wall");
}

void refuse_cell(const Csv& csv, const CsvRow& row, std::size_t column, const std::string& why)
{
    throw ConfigError(csv.path, row.line, csv.head[column], why);
}

} // namespace app
