#pragma once
// Bytes as text inside an HTML page.

#include <string>
#include <string_view>

namespace scanchor {

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);
/// zlib format (RFC 1950), which a browser's DecompressionStream("deflate") opens. Same bytes for
/// the same input and zlib.
std::string deflate(std::string_view bytes);
/// base64(deflate(text)).
std::string packed(std::string_view text);
/// JSON that may stand inside a <script> element: no "<" is left in it.
std::string script_safe(std::string json);

}  // namespace scanchor
