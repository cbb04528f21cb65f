/* Private to the painter: numbers, colours and text in XML, the same in every locale. */
#ifndef VBSS_EXAMPLES_PAINTER_XML_H
#define VBSS_EXAMPLES_PAINTER_XML_H

#include "picture.h"

void xml_put(bytes *to, const char *text); /* as it stands */
void xml_number(bytes *to, double value);  /* at most two decimals */
/* name="value" with a blank before it */
void xml_attribute(bytes *to, const char *name, double value);
void xml_colour(bytes *to, const char *name, painter_colour colour);
/* Escaped; what is not UTF-8, or may not stand in XML, becomes U+FFFD. */
void xml_text(bytes *to, const char *text);

#endif
