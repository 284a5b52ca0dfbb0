#pragma once
/// Numbers and texts as bytes: little endian, no padding, texts and lists behind their length.

#include "app/store/store_error.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace app {

static_assert(std::endian::native == std::endian::little, "the journal is little endian");

template <class T> void put(std::string& bytes, const T& value)
{
    static_assert(std::is_arithmetic_v<T>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T> void put_all(std::string& bytes, const std::vector<T>& values)
{
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

inline void put_text(std::string& bytes, const std::string& text)
{
    put(bytes, static_cast<std::uint64_t>(text.size()));
    bytes += text;
}

/// Takes values off the front; never reads beyond the end.
class ByteDecoder {
  public:
    ByteDecoder(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

    [[noreturn]] void fail() const
    {
        throw StoreError(file_ + ": damaged: a record does not hold what it should");
    }
    std::string_view take(std::uint64_t size)
    {
        if (size > bytes_.size()) fail();
        const std::string_view taken = bytes_.substr(0, static_cast<std::size_t>(size));
        bytes_.remove_prefix(taken.size());
        return taken;
    }
    template <class T> T value()
    {
        T v;
        std::memcpy(&v, take(sizeof v).data(), sizeof v);
        return v;
    }
    template <class T> std::vector<T> values(std::uint64_t n)
    {
        if (n > bytes_.size() / sizeof(T)) fail();
        const std::string_view taken = take(n * sizeof(T));
        std::vector<T> v(static_cast<std::size_t>(n));
        if (n > 0) std::memcpy(v.data(), taken.data(), taken.size());
        return v;
    }
    std::string text() { return std::string(take(value<std::uint64_t>())); }
    /// Number of things of which each takes at least one byte.
    std::uint64_t count()
    {
        const auto n = value<std::uint64_t>();
        if (n > bytes_.size()) fail();
        return n;
    }
    void end() const
    {
        if (!bytes_.empty()) fail();
    }

  private:
    std::string_view bytes_;
    const std::string& file_;
};

} // namespace app
