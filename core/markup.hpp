#pragma once
// Text inside XML and HTML.

#include <string>
#include <string_view>

namespace scanchor {

/// Text for element content and attribute values of XML, SVG and HTML. Control characters, which
/// XML 1.0 forbids, are left out; line ends and tabs stay.
std::string escape_markup(std::string_view text);

}  // namespace scanchor
