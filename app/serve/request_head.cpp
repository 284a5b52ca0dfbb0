#include "app/serve/request_head.hpp"

#include "app/text/words.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <string_view>

namespace app {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string lower(std::string text)
{
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c += 'a' - 'A';
    return text;
}

/// "localhost:4242" is localhost, "[::1]:4242" is ::1; what has no port behind its colon is no
/// name.
std::string without_port(std::string_view authority)
{
    const bool bracket = authority.starts_with('[');
    const std::size_t end = std::min(authority.find(bracket ? ']' : ':'), authority.size());
    std::string_view port = authority.substr(end);
    if (bracket) port = port.starts_with(']') ? port.substr(1) : "[";
    if (!port.empty() &&
        (port.front() != ':' || !std::ranges::all_of(port.substr(1), is_digit)))
        return "";
    return lower(std::string(authority.substr(bracket, end - bracket)));
}

/// "http://localhost:8888" is localhost; "null", of pages without a place, has none.
std::string page_host(std::string_view origin)
{
    const std::size_t scheme = origin.find("://");
    return scheme == std::string_view::npos ? "" : without_port(origin.substr(scheme + 3));
}

bool is_address(const std::string& name)
{
    in6_addr room{};
    return ::inet_pton(AF_INET, name.c_str(), &room) == 1 ||
           ::inet_pton(AF_INET6, name.c_str(), &room) == 1;
}

bool is_trusted(const std::string& name, const ServerNames& names)
{
    return is_loopback(name) || name == lower(names.address) ||
           std::ranges::any_of(names.hosts,
                               [&](const std::string& host) { return lower(host) == name; });
}

bool is_own(const std::string& host, const ServerNames& names)
{
    const bool reached_from_outside = !is_loopback(lower(names.address));
    return is_trusted(host, names) ||
           (!names.machine.empty() && host == lower(names.machine)) ||
           (reached_from_outside && is_address(host));
}

HttpReply forbidden(const std::string& why) { return umbridge_error(403, "Forbidden", why); }

HttpReply malformed(const std::string& why) { return umbridge_error(400, "InvalidInput", why); }

/// Names that others sent, as short as a sentence needs them.
std::string shown(const std::string& name) { return in_quotes(name.substr(0, 80)); }

} // namespace

bool is_loopback(const std::string& name)
{
    in_addr v4{};
    return name == "localhost" || name == "::1" ||
           (name.starts_with("127.") && ::inet_pton(AF_INET, name.c_str(), &v4) == 1);
}

std::optional<HttpReply> refused_by_head(const RequestHead& head, const ServerNames& names)
{
    if (head.host.size() > 1) return malformed("the request has more than one Host");
    for (const std::string& host : head.host)
        if (const std::string name = without_port(host); !is_own(name, names))
            return forbidden(shown(name.empty() ? host : name) +
                             " is not a name of this server: if it is meant to be one, start "
                             "it with --host and this name");
    for (const std::string& origin : head.origin)
        if (!is_trusted(page_host(origin), names))
            return forbidden(
                "the page " + shown(origin) +
                " may not ask this server: if it is meant to, start it with --host "
                "and the name of its machine");
    if (head.content_length.size() > 1)
        return malformed("the request has more than one Content-Length");
    for (const std::string& length : head.content_length)
        if (length.empty() || !std::ranges::all_of(length, is_digit))
            return malformed("Content-Length: must be a number of bytes, in digits");
    for (const std::string& encoding : head.transfer_encoding)
        if (head.transfer_encoding.size() > 1 || !head.content_length.empty() ||
            lower(encoding) != "chunked")
            return malformed("Transfer-Encoding: must be chunked, without a Content-Length");
    return {};
}

} // namespace app
