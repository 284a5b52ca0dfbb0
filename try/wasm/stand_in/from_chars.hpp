#pragma once
/// libc++ 19 reads no double by std::from_chars. strtod of wasi-libc rounds correctly and knows
/// no locale, but takes more: blanks, a plus, hexadecimals, which are refused here.

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <system_error>

namespace std {

inline from_chars_result from_chars(const char* first, const char* last, double& value)
{
    const string text(first, last);
    const size_t digits = text.starts_with('-') ? 1 : 0;
    const bool number = digits < text.size() &&
                        (text[digits] == '.' || (text[digits] >= '0' && text[digits] <= '9'));
    const bool word =
        text.compare(digits, 3, "inf") == 0 || text.compare(digits, 3, "nan") == 0;
    if (!number && !word) return {first, errc::invalid_argument};
    const bool hexadecimal =
        digits + 1 < text.size() && text[digits] == '0' && (text[digits + 1] | 32) == 'x';
    if (hexadecimal) {
        value = 0.0;
        return {first + digits + 1, errc()};
    }
    char* end = nullptr;
    const double read = strtod(text.c_str(), &end);
    const char* const at = first + (end - text.c_str());
    if (at == first) return {first, errc::invalid_argument};
    if (!word && (isinf(read) || (read == 0.0 && text.find_first_of("123456789") <
                                                     static_cast<size_t>(end - text.c_str()))))
        return {at, errc::result_out_of_range};
    value = read;
    return {at, errc()};
}

} // namespace std
