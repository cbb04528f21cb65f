/* What the page is made of beside the session, as it was built in: assets.cmake. */
#ifndef VBSS_EXAMPLES_REPLAY_PAGE_ASSETS_H
#define VBSS_EXAMPLES_REPLAY_PAGE_ASSETS_H

#include <stddef.h>

extern const unsigned char asset_page[], asset_style[], asset_player[];
extern const size_t asset_page_size, asset_style_size, asset_player_size;

#endif
