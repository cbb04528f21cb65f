/* The number pi. */
#ifndef VBSS_BASE_PI_H
#define VBSS_BASE_PI_H

#define VBSS_PI 3.14159265358979323846
#define VBSS_TWO_PI (2.0 * VBSS_PI) /* exact: the nearest double of 2 pi */

#endif
