#include "fragility/codes/code_text.hpp"

#include "fragility/codes/code_table.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace fragility {
namespace {

constexpr std::size_t kDeepest = 16;

/// Takes the parts of a text as the parser meets them. The parser keeps no lines: `place` is
/// how far it has come.
class CodeTextReader : public nlohmann::json_sax<nlohmann::json> {
  public:
    CodeTextReader(std::string_view text, const std::size_t& place) : text_(text), place_(place)
    {
    }
    CodeNode root;

    bool null() override { return add({}); }
    bool boolean(bool) override { return add({}); }
    bool number_integer(number_integer_t) override { return add({}); }
    bool number_unsigned(number_unsigned_t) override { return add({}); }
    bool number_float(number_float_t, const string_t&) override { return add({}); }
    bool binary(binary_t&) override { return add({}); }
    bool string(string_t& value) override
    {
        CodeNode node;
        node.kind = CodeNode::Kind::text;
        node.text = value;
        return add(std::move(node));
    }
    bool start_object(std::size_t) override { return begin(CodeNode::Kind::object); }
    bool start_array(std::size_t) override { return begin(CodeNode::Kind::list); }
    bool end_object() override { return end(); }
    bool end_array() override { return end(); }
    bool key(string_t& name) override
    {
        auto& members = begun_.back().members;
        if (std::ranges::find(members, name, &CodeNode::key) != members.end())
            throw CodeTableError(line(), name, "stands twice in one object; keep one of them");
        members.emplace_back();
        members.back().key = name;
        members.back().line = line();
        return true;
    }
    bool parse_error(std::size_t, const std::string&,
                     const nlohmann::detail::exception&) override
    {
        throw CodeTableError(line(), "",
                             "is not JSON from here on; look for a comma, a quotation mark or "
                             "a bracket that is missing or too many");
    }

  private:
    int line()
    {
        for (; counted_ < place_; ++counted_) line_ += text_[counted_] == '\n' ? 1 : 0;
        return line_;
    }

    bool add(CodeNode node)
    {
        node.line = line();
        if (begun_.empty()) {
            root = std::move(node);
        } else if (begun_.back().kind == CodeNode::Kind::list) {
            begun_.back().elements.push_back(std::move(node));
        } else {
            CodeNode& value = begun_.back().members.back();
            node.line = value.line;
            node.key = value.key;
            value = std::move(node);
        }
        return true;
    }

    bool begin(CodeNode::Kind kind)
    {
        if (begun_.size() >= kDeepest)
            throw CodeTableError(line(), "", "is nested too deeply for a table of codes");
        begun_.emplace_back();
        begun_.back().kind = kind;
        lines_.push_back(line());
        return true;
    }

    bool end()
    {
        CodeNode node = std::move(begun_.back());
        begun_.pop_back();
        const int began = lines_.back();
        lines_.pop_back();
        const bool element = begun_.empty() || begun_.back().kind == CodeNode::Kind::list;
        add(std::move(node));
        if (begun_.empty())
            root.line = began;
        else if (element)
            begun_.back().elements.back().line = began;
        return true;
    }

    std::string_view text_;
    const std::size_t& place_;
    std::size_t counted_ = 0; ///< of the text, for `line_`
    int line_ = 1;
    std::vector<CodeNode> begun_;
    std::vector<int> lines_;
};

/// Tells how far the parser has come.
struct CountedText {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    std::string_view text;
    std::size_t* place = nullptr;
    std::size_t at = 0;

    const char& operator*() const { return text[at]; }
    CountedText& operator++()
    {
        *place = ++at;
        return *this;
    }
    bool operator==(const CountedText& other) const { return at == other.at; }
    bool operator!=(const CountedText& other) const { return at != other.at; }
};

} // namespace

CodeNode parse_code_text(std::string_view text)
{
    std::size_t place = 0;
    CodeTextReader reader(text, place);
    nlohmann::json::sax_parse(CountedText{text, &place, 0},
                              CountedText{text, &place, text.size()}, &reader);
    return std::move(reader.root);
}

} // namespace fragility
