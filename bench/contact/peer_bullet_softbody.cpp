/* Peer: Bullet's btSoftBody as a rope in float64: distances between neighbours by sweeps over the
 * positions, and contacts of the rope with itself between clusters, one to each segment.
 *
 * The knot is lost as soon as it is tight, with every choice tried: contacts change velocities before
 * the distances are swept, so that the distances have the last word and pull the rope through
 * itself. Friction is a share of the sliding that is taken away, not Coulomb's law; the tension is
 * what the unfinished sweeps leave, and grows with their number and the square of 1 / step.
 *
 * Chosen by trial, in its favour:
 * - Bullet makes clusters of tetrahedra or faces only, which a rope has not: here they are made of a
 *   segment's two nodes. Their inertia about their own axis is none, where Bullet divides by it:
 *   mended in each step.
 * - CL_SELF does not work in this version: its collision mask takes the flag for another kind. The
 *   collider behind it is called instead, and does.
 * - No bending: links to every other node, of any strength that matters, lose the knot earlier (at
 *   121 nodes after 0.45 s instead of 0.67 s of pulling, at 61 after 0.8 s instead of 1.1 s). A
 *   physical EI there is not.
 * - 50 sweeps of the distances in mixed order, 20 of the contacts; 200 and 5 to 100 end alike, and
 *   so do steps of 1 to 1/256 ms, split impulses, and sweeps of the drift.
 * - The ends are nodes of a kilogram, put back after each step: how far the sweeps moved them tells
 *   the tension.
 * - Millimetres, milligrams, milliseconds. */
#include <cmath>
#include <new>
#include <vector>

#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyInternals.h>

#include "peer.h"

#if !defined(BT_USE_DOUBLE_PRECISION)
#error "the float64 build of Bullet is the one to compare with"
#endif

namespace
{

const double mm = 1e3, mg = 1e6, ms = 1e3, millinewton = 1e3; /* in a m, kg, s, N */
const double end_mass = 1e6;                                  /* mg */
const double damping = 0.1;                                   /* 1/ms */
const int distance_sweeps = 50, contact_sweeps = 20;
/* Nearer along the thread than this many diameters segments may touch: a bend is no contact. */
const double bend = 1.6;

btVector3 place(const double *position)
{
    return mm * btVector3(position[0], position[1], position[2]);
}

struct rope {
    rope(const contact_peer_scene &scene, const std::vector<btVector3> &places,
         const std::vector<btScalar> &masses, double step);
    void add_clusters();
    void connect_neighbours(double reach);
    void mend_clusters();
    void touch();

    btSoftBodyWorldInfo world;
    btSoftBody body;
    double dt;   /* ms */
    double pull; /* N */
    btVector3 ends[2];
};

rope::rope(const contact_peer_scene &scene, const std::vector<btVector3> &places,
           const std::vector<btScalar> &masses, double step)
    : world(), body(&world, (int)places.size(), places.data(), masses.data()), dt(step * ms),
      pull(0.0), ends{places.front(), places.back()}
{
    world.m_gravity.setZero();
    for (int i = 0; i + 1 < body.m_nodes.size(); i++) {
        body.appendLink(i, i + 1);
    }
    body.randomizeConstraints();
    body.m_cfg.piterations = distance_sweeps;
    body.m_cfg.citerations = contact_sweeps;
    body.m_cfg.kDP = std::fmin(1.0, damping * dt);
    body.m_cfg.kDF = scene.friction;
    body.m_cfg.kSSHR_CL = 1; /* all of a penetration is taken back in a step */
    body.m_cfg.kSS_SPLT_CL = 0;
    body.getCollisionShape()->setMargin(0.5 * scene.diameter * mm);
    add_clusters();
    connect_neighbours(bend * scene.diameter * mm);
}

void rope::add_clusters()
{
    for (int i = 0; i + 1 < body.m_nodes.size(); i++) {
        void *memory = btAlignedAlloc(sizeof(btSoftBody::Cluster), 16); /* as it is freed */
        btSoftBody::Cluster *cluster = new (memory) btSoftBody::Cluster();
        cluster->m_collide = true;
        cluster->m_clusterIndex = i;
        cluster->m_nodes.push_back(&body.m_nodes[i]);
        cluster->m_nodes.push_back(&body.m_nodes[i + 1]);
        body.m_clusters.push_back(cluster);
    }
    body.initializeClusters();
    body.updateClusters();
}

/* Connected clusters are not in contact. */
void rope::connect_neighbours(double reach)
{
    int count = body.m_clusters.size();
    body.m_clusterConnectivity.resize(count * count, false);
    for (int i = 0; i < count; i++) {
        double between = 0.0;
        for (int j = i; j < count && between < reach; j++) {
            body.m_clusterConnectivity[i + count * j] = true;
            body.m_clusterConnectivity[j + count * i] = true;
            if (j > i) {
                between += (body.m_nodes[j + 1].m_x - body.m_nodes[j].m_x).length();
            }
        }
    }
}

/* Motion and inverse inertia of two masses on a rigid rod, and a box that is wide enough. */
void rope::mend_clusters()
{
    const btScalar margin = body.getCollisionShape()->getMargin();
    for (int i = 0; i < body.m_clusters.size(); i++) {
        btSoftBody::Cluster &c = *body.m_clusters[i];
        const btSoftBody::Node &a = *c.m_nodes[0], &b = *c.m_nodes[1];
        const btVector3 rod = b.m_x - a.m_x;
        double ma = 1.0 / a.m_im, mb = 1.0 / b.m_im, square = rod.length2();
        double inertia = ma * mb / (ma + mb) * square;
        c.m_framexform = btTransform(btMatrix3x3::getIdentity(), c.m_com);
        c.m_lv = (ma * a.m_v + mb * b.m_v) / (ma + mb);
        c.m_av = rod.cross(b.m_v - a.m_v) / square;
        for (int row = 0; row < 3; row++) {
            for (int k = 0; k < 3; k++) {
                c.m_invwi[row][k] = ((row == k ? 1.0 : 0.0) - rod[row] * rod[k] / square) / inertia;
            }
        }
        c.m_locii = c.m_invwi;
        btVector3 low = a.m_x, high = a.m_x;
        low.setMin(b.m_x);
        high.setMax(b.m_x);
        btDbvtVolume box = btDbvtVolume::FromMM(low, high);
        box.Expand(btVector3(margin, margin, margin));
        body.m_cdbvt.update(c.m_leaf, box);
    }
}

/* What a world does for its soft bodies. */
void rope::touch()
{
    btSoftColliders::CollideCL_SS collider;
    collider.ProcessSoftSoft(&body, &body);
    body.prepareClusters(contact_sweeps);
    for (int sweep = 0; sweep < contact_sweeps; sweep++) {
        body.solveClusters(1.0);
    }
    body.cleanupClusters();
}

/* ---- the peer */

void *create(const contact_peer_scene *scene, size_t nodes, const double *positions, double step)
{
    if (nodes < 3) {
        return nullptr;
    }
    std::vector<btVector3> places;
    std::vector<btScalar> masses(nodes, 0.0);
    for (size_t i = 0; i < nodes; i++) {
        places.push_back(place(positions + 3 * i));
    }
    for (size_t i = 0; i + 1 < nodes; i++) {
        double half = 0.5 * scene->linear_density / mm * mg * (places[i + 1] - places[i]).length();
        masses[i] += half;
        masses[i + 1] += half;
    }
    masses.front() = masses.back() = end_mass;
    return new (std::nothrow) rope(*scene, places, masses, step);
}

int step(void *peer, const double end_a[3], const double end_b[3], double h)
{
    rope &r = *static_cast<rope *>(peer);
    int steps = (int)std::ceil(h * ms / r.dt - 1e-9);
    double dt = h * ms / steps;
    const btVector3 from[2] = {r.ends[0], r.ends[1]}, to[2] = {place(end_a), place(end_b)};
    btSoftBody::Node *nodes[2] = {&r.body.m_nodes[0], &r.body.m_nodes[r.body.m_nodes.size() - 1]};
    r.pull = 0.0;
    for (int i = 1; i <= steps; i++) {
        for (int e = 0; e < 2; e++) {
            r.ends[e] = from[e] + (to[e] - from[e]) * i / steps;
            nodes[e]->m_v = (r.ends[e] - nodes[e]->m_x) / dt;
        }
        r.body.predictMotion(dt);
        r.mend_clusters();
        r.touch();
        r.body.solveConstraints();
        r.body.integrateMotion();
        for (int e = 0; e < 2; e++) {
            double moved = (r.ends[e] - nodes[e]->m_x).length();
            r.pull += 0.5 * end_mass * moved / (dt * dt) / steps / millinewton;
            nodes[e]->m_x = r.ends[e];
        }
    }
    const btVector3 &middle = r.body.m_nodes[r.body.m_nodes.size() / 2].m_x;
    return std::isfinite(middle[0] + middle[1] + middle[2] + r.pull) ? 0 : 1;
}

size_t read_nodes(void *peer, double *positions)
{
    rope &r = *static_cast<rope *>(peer);
    for (int i = 0; i < r.body.m_nodes.size(); i++) {
        for (int k = 0; k < 3; k++) {
            positions[3 * i + k] = r.body.m_nodes[i].m_x[k] / mm;
        }
    }
    return (size_t)r.body.m_nodes.size();
}

double tension(void *peer)
{
    return static_cast<rope *>(peer)->pull;
}

void destroy(void *peer)
{
    delete static_cast<rope *>(peer);
}

} /* namespace */

const contact_peer contact_bullet_softbody = {
    "bullet-softbody",
    "Bullet " PEER_TEXT(BT_BULLET_VERSION) " btSoftBody, float64: distances along a rope, 50"
                                           " sweeps, self-contact of clusters; no EI",
    create,
    step,
    read_nodes,
    tension,
    destroy,
    {0.25e-3, 0.25e-3, 0.25e-3}};
