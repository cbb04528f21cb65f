/* Numbers in texts, with a decimal point in every locale. */
#ifndef VBSS_BASE_NUMBER_TEXT_H
#define VBSS_BASE_NUMBER_TEXT_H

/* The text of one number, with a final zero. */
typedef struct vbss_number_text {
    char text[32];
} vbss_number_text;

/* Formats a number as the conversion %g does in the C locale. `digits` is the number of significant
 * digits, 1 to 17. */
vbss_number_text vbss_format_number(double value, int digits);

/* The text of a number with six significant digits, for an argument of a call: it is valid until
 * the end of the full expression. */
#define VBSS_NUMBER(value) (vbss_format_number((value), 6).text)

#endif
