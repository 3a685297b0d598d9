// The #include directives of a source text, however they are written.

#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace ffgpu {

// The text with no comments, no continued lines and line feeds alone: what the preprocessor's
// directives are read from. A quote within a comment or a string does not begin the other.
inline std::string plain_text(const std::string& text) {
    static const std::regex continued("\\\\\r?\n"), carriage_return("\r");
    static const std::regex comment_or_literal(
        R"re(//[^\n]*|/\*(?:[^*]|\*+[^*/])*\*+/|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)+')re");
    const std::string joined =
        std::regex_replace(std::regex_replace(text, continued, ""), carriage_return, "");
    std::string plain;
    auto from = joined.begin();
    for (std::sregex_iterator it(joined.begin(), joined.end(), comment_or_literal), end; it != end;
         ++it) {
        plain.append(from, joined.begin() + it->position());
        plain += (*it)[0].str()[0] == '/' ? " " : (*it)[0].str();
        from = joined.begin() + it->position() + it->length();
    }
    return plain.append(from, joined.end());
}

struct Include {
    std::string path;     // as it stands there
    bool is_plain = true; // "path" or <path>, by #include; not by a macro, #import and the like
    bool is_quoted = false;
};

inline std::vector<Include> includes_of(const std::string& text) {
    static const std::regex directive(
        R"re(\s*(?:#|%:|\?\?=)\s*(include|include_next|import)\b\s*(.*))re");
    static const std::regex target(R"re(["<]([^">]*)[">]\s*)re");
    std::vector<Include> found;
    std::istringstream lines(plain_text(text));
    for (std::string line; std::getline(lines, line);) {
        std::smatch parts, path;
        if (line.find("clude") == std::string::npos && line.find("import") == std::string::npos)
            continue;
        if (!std::regex_match(line, parts, directive)) continue;
        const std::string rest = parts[2].str() + ' ';
        const bool named = std::regex_match(rest, path, target);
        found.push_back(
            {named ? path[1].str() : rest, named && parts[1] == "include", rest[0] == '"'});
    }
    return found;
}

inline std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace ffgpu
