#include "report/page.hpp"

#include "core/expect.hpp"

// From the assembler file that cmake/Web.cmake generates around the page.
extern "C" {
extern const char carom_page_template_begin[];
extern const char carom_page_template_end[];
}

namespace carom {

std::string_view page_template()
{
    return {carom_page_template_begin, static_cast<std::size_t>(carom_page_template_end - carom_page_template_begin)};
}

std::string comparison_page(std::string_view data_json)
{
    const std::string_view page = page_template();
    const std::size_t marker = page.find(page_data_marker);
    CAROM_EXPECT(marker != std::string_view::npos);
    std::string result(page.substr(0, marker));
    for (const char c : data_json) {
        if (c == '<')
            result += "\\u003c";  // JSON has '<' in strings only, and there this is the same character
        else
            result += c;
    }
    result += page.substr(marker + page_data_marker.size());
    return result;
}

}  // namespace carom
