/* A font of strokes: each character is lines between points of a small grid. */
#ifndef VBSS_EXAMPLES_PAINTER_FONT_H
#define VBSS_EXAMPLES_PAINTER_FONT_H

/* Strokes of the first character of *text, which moves on to the next one: pairs of digits "xy", strokes parted by blanks; x to
 * the right, y up: 2 is the base line, 6 the height of an x, 8 of an X. A single pair is a dot. */
const char *font_glyph(const char **text);
/* From its beginning to that of the next character, in the same units. */
double font_advance(const char *glyph);
double font_width(const char *text);

#endif
