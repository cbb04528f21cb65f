/* What compilers like best to fuse, compiled as the library is; nobody calls it. gate.fma looks at it. */

typedef struct quaternion {
    double w, x, y, z;
} quaternion;

void vbss_product(const quaternion *a, const quaternion *b, quaternion *c);
void vbss_loop(double *restrict c, const double *restrict a, const double *restrict b);

void vbss_product(const quaternion *a, const quaternion *b, quaternion *c)
{
    quaternion r = {a->w * b->w - a->x * b->x - a->y * b->y - a->z * b->z,
                    a->w * b->x + a->x * b->w + a->y * b->z - a->z * b->y,
                    a->w * b->y - a->x * b->z + a->y * b->w + a->z * b->x,
                    a->w * b->z + a->x * b->y - a->y * b->x + a->z * b->w};
    *c = r;
}

/* The same in a loop: another vectoriser, which armv8.3-a gives complex instructions to fuse. */
void vbss_loop(double *restrict c, const double *restrict a, const double *restrict b)
{
    for (int i = 0; i < 1024; i += 2) {
        c[i] = a[i] * b[i] - a[i + 1] * b[i + 1];
        c[i + 1] = a[i] * b[i + 1] + a[i + 1] * b[i];
    }
}
