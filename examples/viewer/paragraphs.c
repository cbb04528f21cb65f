#include "paragraphs.h"

#include <string.h>

#define CHARACTER 0.72F /* of a letter's height, its width with the space after it */

size_t paragraphs_room(const show *s)
{
    return (size_t)((s->wide - 2.0F * SHOW_MARGIN) / (CHARACTER * SHOW_TEXT));
}

void paragraphs_add(paragraphs *l, size_t room, pen_colour colour, const char *text)
{
    room = room < PARAGRAPHS_LINE ? room : PARAGRAPHS_LINE - 1;
    while (*text != '\0' && l->count < PARAGRAPHS_LINES) {
        size_t length = strlen(text);
        if (length > room) {
            length = room;
            while (length > 1 && text[length] != ' ') {
                length--;
            }
        }
        memcpy(l->text[l->count], text, length);
        l->text[l->count][length] = '\0';
        l->colours[l->count++] = colour;
        text += length + (text[length] == ' ');
    }
}

void paragraphs_put(show *s, const paragraphs *l, float below)
{
    float y = s->tall - SHOW_MARGIN - (below + (float)l->count) * SHOW_LINE;
    pen_box(&s->pen, 0.5F * SHOW_MARGIN, y, s->wide - SHOW_MARGIN,
            SHOW_LINE * ((float)l->count + 0.5F), PEN_SHADE);
    for (int i = 0; i < l->count; i++) {
        y += SHOW_LINE;
        pen_text(&s->pen, SHOW_MARGIN, y, SHOW_TEXT, l->colours[i], l->text[i]);
    }
}
