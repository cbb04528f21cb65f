/* A block of soft tissue: linear tetrahedra, implicit steps, conjugate gradients: an example of a host's own model. */
#ifndef EXAMPLES_HOST_TISSUE_FEM_H
#define EXAMPLES_HOST_TISSUE_FEM_H

#include <stdint.h>

/* Sizes of a block. y points up: the lowest layer of nodes is fixed, the highest is the surface. */
typedef struct fem_config {
    int cells[3];   /* cubes along x, y and z, each of six tetrahedra */
    double side;    /* of a cube, m */
    double young;   /* N/m^2 */
    double poisson; /* ratio, below 0.5 */
    double density; /* kg/m^3 */
    double damping; /* of the velocity, 1/s */
    double h;       /* step, s */
} fem_config;

/* Neighbours of a node in the grid, itself included: offsets of -1 to 1 along z, x and y. */
enum { FEM_NEIGHBOURS = 27 };

typedef struct fem {
    fem_config config;
    int nodes, row, layer;                  /* nodes in all, along z, and of a layer */
    int first_surface;                      /* first node of the highest layer */
    double (*rest)[3];                      /* m */
    double *mass;                           /* kg */
    double (*stiffness)[FEM_NEIGHBOURS][9]; /* blocks of 3 x 3, N/m */
    char (*is_coupled)[FEM_NEIGHBOURS];     /* some tetrahedron has both nodes */
    double (*u)[3], (*v)[3];                /* displacements, m, and velocities, m/s */
    double (*next)[3]; /* displacements that a step reaches without forces, m */
    double (*solution)[3], (*residual)[3], (*direction)[3],
        (*product)[3]; /* of conjugate gradients */
} fem;

/* Returns 0 without memory. */
int fem_create(fem *f, const fem_config *config);
void fem_destroy(fem *f);

/* Where the surface goes in a step without forces, m. */
void fem_predict(fem *f, double (*surface)[3]);
/* Ends the step with forces on the vertices of the surface, N. */
void fem_apply(fem *f, const double (*forces)[3]);
/* Compliance of a surface vertex in a step, m/N: its displacement by a force on it, plus twice the mean displacement of its
 * neighbours in the surface by that force. A force on the middle of a triangle then moves that point as far as in the whole
 * model. `alone`: without the neighbours. */
void fem_compliance(fem *f, int vertex, int alone, double block[9]);
/* Force of the tissue on the support of its lowest layer, N. */
void fem_reaction(const fem *f, double force[3]);
/* Elastic force on a vertex of the surface, N. At rest it is the opposite of the force that acts there. */
void fem_elastic_force(const fem *f, int vertex, double force[3]);

#endif
