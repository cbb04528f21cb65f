/* Peer: Bullet's btMultiBody in float64. The thread is a chain of rigid capsules with spherical
 * joints, rooted at its middle; contacts, friction and the held ends are rows for Bullet's
 * projected Gauss-Seidel in joint coordinates. EI comes as a torque at each joint, explicit in time.
 *
 * Chosen by trial, in its favour:
 * - Turning inertia: links that turn explicitly in time under a tension T shake themselves to pieces
 *   above T = linear density * l^2 / h^2, 6 mN at 61 nodes and 1/4 ms. Each link is given h^2 l T
 *   more, four times the limit, and a drag that takes nine tenths of its turning a step; the torques
 *   at the joints are stable with it, too. The price is a tension that reads too high while the knot
 *   runs in, in proportion to the step.
 * - Warm starting (off by default), and eight tenths of a penetration taken back in a step
 *   (two tenths by default): with the defaults the knot was lost at 61 nodes and 1/16 ms, each by
 *   itself was enough to keep it. Split impulses are off, as multibodies have none and would keep
 *   deep penetrations.
 * - Up to 300 sweeps, fewer where little is left to do. A contact of the body with itself counts as
 *   one of two bodies in the diagonal of its row, and converges slowly: with 100 sweeps the smallest
 *   distance was 0.42 D, with 300 0.75 D (61 nodes, 1/4 ms).
 * - Friction in two directions, its cone round. Bullet multiplies the friction of two bodies: each
 *   has the root.
 * - Millimetres, milligrams, milliseconds: its contact margin is then 2 % of half a capsule. */
#include <cmath>
#include <cstddef>
#include <memory>
#include <new>
#include <vector>

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <BulletDynamics/Featherstone/btMultiBodyPoint2Point.h>

#include "peer.h"

#if !defined(BT_USE_DOUBLE_PRECISION)
#error "the float64 build of Bullet is the one to compare with"
#endif

namespace
{

const double mm = 1e3, mg = 1e6, ms = 1e3, millinewton = 1e3; /* in a m, kg, s, N */
const int sweeps = 300;
const double sweeps_end = 1e-10; /* square of the largest impulse left, mg mm/ms */
const double turning_lost = 0.9; /* of a link's turning, in a step */
const double penetration_share = 0.8, hold_share = 0.5; /* of an error, taken back in a step */
const double warm_share = 0.85;

btVector3 place(const double *positions, int node)
{
    const double *at = positions + 3 * static_cast<std::ptrdiff_t>(node);
    return mm * btVector3(at[0], at[1], at[2]);
}

/* The least rotation that turns direction a into b, both of length one. */
btQuaternion min_rotation(const btVector3 &a, const btVector3 &b)
{
    btVector3 axis = a.cross(b);
    return btQuaternion(axis[0], axis[1], axis[2], 1.0 + a.dot(b)).normalized();
}

struct chain {
    chain(const contact_peer_scene &scene, const double *positions, int links, double step);
    ~chain();
    void set_up_links(const contact_peer_scene &scene);
    void set_places(const double *positions);
    void add_colliders(const contact_peer_scene &scene);
    void add_holds(const double *positions);
    void choose_solver();
    void bend();
    void drag(double h);

    /* Of the segment i: the links right of the root come first, in their order along the thread,
     * then those left of it, from the root outward. The root is the base, -1. */
    int link(int i) const
    {
        return i >= root ? i - root - 1 : links - 2 - i;
    }
    int parent(int i) const
    {
        return i > root ? i - 1 : i + 1;
    }

    int links, root;
    double dt, bending_stiffness;                 /* ms, mN mm^2 */
    double pull;                                  /* N */
    std::vector<double> lengths, turning_inertia; /* mm, mg mm^2: each link's, added to its own */

    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher;
    btDbvtBroadphase broadphase;
    btMultiBodyConstraintSolver solver;
    btMultiBodyDynamicsWorld world;
    std::unique_ptr<btMultiBody> body;
    std::vector<std::unique_ptr<btCapsuleShapeX>> shapes;
    std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders;
    std::unique_ptr<btMultiBodyPoint2Point> holds[2];
    btVector3 ends[2];
    btAlignedObjectArray<btQuaternion> scratch_turns; /* Bullet sizes them in the first step */
    btAlignedObjectArray<btVector3> scratch_places, turning, moving;
};

chain::chain(const contact_peer_scene &scene, const double *positions, int links_, double step)
    : links(links_), root(links_ / 2), dt(step * ms),
      bending_stiffness(scene.bending_stiffness * millinewton * mm * mm), pull(0.0),
      dispatcher(&configuration), world(&dispatcher, &broadphase, &solver, &configuration)
{
    for (int i = 0; i < links; i++) {
        lengths.push_back((place(positions, i + 1) - place(positions, i)).length());
        turning_inertia.push_back(dt * dt * lengths[i] * scene.tension * millinewton);
    }
    set_up_links(scene);
    set_places(positions);
    add_colliders(scene);
    add_holds(positions);
    choose_solver();
    turning.resize(links);
    moving.resize(links);
}

chain::~chain()
{
    for (auto &hold : holds) {
        world.removeMultiBodyConstraint(hold.get());
    }
    for (auto &collider : colliders) {
        world.removeCollisionObject(collider.get());
    }
    world.removeMultiBody(body.get());
}

/* Half of each link's mass is at each of its ends. */
void chain::set_up_links(const contact_peer_scene &scene)
{
    const btQuaternion straight(0, 0, 0, 1);
    auto mass = [&](int i) { return scene.linear_density / mm * mg * lengths[i]; };
    auto inertia = [&](int i) {
        double all = 0.25 * mass(i) * lengths[i] * lengths[i] + turning_inertia[i];
        return btVector3(all, all, all);
    };
    auto join = [&](int i) {
        double side = i > root ? 0.5 : -0.5;
        body->setupSpherical(link(i), mass(i), inertia(i), link(parent(i)), straight,
                             btVector3(side * lengths[parent(i)], 0, 0),
                             btVector3(side * lengths[i], 0, 0), true);
    };
    body.reset(new btMultiBody(links - 1, mass(root), inertia(root), false, false));
    for (int i = root + 1; i < links; i++) {
        join(i);
    }
    for (int i = root - 1; i >= 0; i--) {
        join(i);
    }
    body->finalizeMultiDof();
    body->setLinearDamping(0);
    body->setAngularDamping(0);
    body->setMaxCoordinateVelocity(1e9);
    body->setMaxAppliedImpulse(1e30);
    body->setUseGyroTerm(false); /* of an inertia that is not there */
    body->setHasSelfCollision(true);
    world.setGravity(btVector3(0, 0, 0));
    world.addMultiBody(body.get());
}

/* Without twist from each link to the next. */
void chain::set_places(const double *positions)
{
    std::vector<btQuaternion> turns;
    btVector3 along(1, 0, 0);
    btQuaternion turn(0, 0, 0, 1);
    for (int i = 0; i < links; i++) {
        btVector3 next = (place(positions, i + 1) - place(positions, i)).normalized();
        turn = min_rotation(along, next) * turn;
        turns.push_back(turn);
        along = next;
    }
    btVector3 centre = 0.5 * (place(positions, root) + place(positions, root + 1));
    body->setBaseWorldTransform(btTransform(turns[root], centre));
    for (int i = 0; i < links; i++) {
        if (i != root) {
            btQuaternion joint = turns[parent(i)].inverse() * turns[i];
            const btScalar q[4] = {joint.x(), joint.y(), joint.z(), joint.w()};
            body->setJointPosMultiDof(link(i), q);
        }
    }
    body->setCanSleep(false);
}

void chain::add_colliders(const contact_peer_scene &scene)
{
    for (int i = 0; i < links; i++) {
        shapes.emplace_back(new btCapsuleShapeX(0.5 * scene.diameter * mm, lengths[i]));
        colliders.emplace_back(new btMultiBodyLinkCollider(body.get(), link(i)));
        btMultiBodyLinkCollider *collider = colliders.back().get();
        collider->setCollisionShape(shapes.back().get());
        collider->setFriction(std::sqrt(scene.friction));
        if (link(i) < 0) {
            body->setBaseCollider(collider);
        } else {
            body->getLink(link(i)).m_collider = collider;
        }
        world.addCollisionObject(collider, btBroadphaseProxy::DefaultFilter,
                                 btBroadphaseProxy::AllFilter);
    }
    body->forwardKinematics(scratch_turns, scratch_places);
    body->updateCollisionObjectWorldTransforms(scratch_turns, scratch_places);
}

void chain::add_holds(const double *positions)
{
    for (int e = 0; e < 2; e++) {
        int i = e == 0 ? 0 : links - 1;
        const btVector3 end((e == 0 ? -0.5 : 0.5) * lengths[i], 0, 0);
        ends[e] = place(positions, e * links);
        holds[e].reset(new btMultiBodyPoint2Point(
            body.get(), link(i), static_cast<btRigidBody *>(nullptr), end, ends[e]));
        holds[e]->setMaxAppliedImpulse(1e30);
        world.addMultiBodyConstraint(holds[e].get());
        holds[e]->finalizeMultiDof();
    }
}

void chain::choose_solver()
{
    btContactSolverInfo &info = world.getSolverInfo();
    info.m_numIterations = sweeps;
    info.m_leastSquaresResidualThreshold = sweeps_end;
    info.m_splitImpulse = 0;
    info.m_erp = hold_share;
    info.m_erp2 = penetration_share;
    info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS | SOLVER_USE_ARTICULATED_WARMSTARTING;
    info.m_articulatedWarmstartingFactor = warm_share;
}

/* Torque -EI / l times the rotation vector of each joint; twist has the same stiffness. */
void chain::bend()
{
    for (int i = 0; i < links; i++) {
        if (i == root) {
            continue;
        }
        const btScalar *q = body->getJointPosMultiDof(link(i)); /* x, y, z, w */
        btScalar *torque = body->getJointTorqueMultiDof(link(i));
        double stiffness = 2.0 * bending_stiffness / (lengths[i] + lengths[parent(i)]);
        double w = std::fabs(q[3]), s = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2]);
        double scale = s > 1e-9 ? 2.0 * std::atan2(s, w) / s : 2.0;
        scale *= q[3] < 0.0 ? stiffness : -stiffness;
        for (int k = 0; k < 3; k++) {
            torque[k] = scale * q[k];
        }
    }
}

void chain::drag(double h)
{
    body->compTreeLinkVelocities(&turning[0], &moving[0]); /* in the links' frames, base first */
    for (int i = 0; i < links; i++) {
        btVector3 torque = -turning_lost / h * turning_inertia[i] * turning[link(i) + 1];
        torque = body->localDirToWorld(link(i), torque);
        if (i == root) {
            body->addBaseTorque(torque);
        } else {
            body->addLinkTorque(link(i), torque);
        }
    }
}

/* ---- the peer */

void *create(const contact_peer_scene *scene, size_t nodes, const double *positions, double step)
{
    return nodes < 3 ? nullptr : new (std::nothrow) chain(*scene, positions, (int)nodes - 1, step);
}

int step(void *peer, const double end_a[3], const double end_b[3], double h)
{
    chain &c = *static_cast<chain *>(peer);
    int steps = (int)std::ceil(h * ms / c.dt - 1e-9);
    double dt = h * ms / steps;
    const btVector3 from[2] = {c.ends[0], c.ends[1]}, to[2] = {place(end_a, 0), place(end_b, 0)};
    c.pull = 0.0;
    for (int i = 1; i <= steps; i++) {
        c.bend();
        c.drag(dt);
        for (int e = 0; e < 2; e++) {
            c.ends[e] = from[e] + (to[e] - from[e]) * i / steps;
            c.holds[e]->setPivotInB(c.ends[e]);
        }
        c.world.stepSimulation(dt, 0);
        for (auto &hold : c.holds) {
            btVector3 impulse(hold->getAppliedImpulse(0), hold->getAppliedImpulse(1),
                              hold->getAppliedImpulse(2));
            c.pull += 0.5 * impulse.length() / dt / steps / millinewton;
        }
    }
    const btVector3 &middle = c.body->getBasePos();
    return std::isfinite(middle[0] + middle[1] + middle[2] + c.pull) ? 0 : 1;
}

size_t read_nodes(void *peer, double *positions)
{
    chain &c = *static_cast<chain *>(peer);
    c.body->forwardKinematics(c.scratch_turns, c.scratch_places);
    for (int i = 0; i <= c.links; i++) {
        int segment = i < c.links ? i : i - 1, link = c.link(segment);
        const btVector3 node((i < c.links ? -0.5 : 0.5) * c.lengths[segment], 0, 0);
        const btTransform frame = link < 0 ? c.body->getBaseWorldTransform()
                                           : c.body->getLink(link).m_cachedWorldTransform;
        const btVector3 at = frame * node;
        for (int k = 0; k < 3; k++) {
            positions[3 * i + k] = at[k] / mm;
        }
    }
    return (size_t)c.links + 1;
}

double tension(void *peer)
{
    return static_cast<chain *>(peer)->pull;
}

void destroy(void *peer)
{
    delete static_cast<chain *>(peer);
}

} /* namespace */

/* Of 1, 1/2, ... 1/32 ms. */
const contact_peer contact_bullet_multibody = {
    "bullet-multibody",
    "Bullet " PEER_TEXT(BT_BULLET_VERSION) " btMultiBody, float64: capsules, spherical joints;"
                                           " turning inertia added",
    create,
    step,
    read_nodes,
    tension,
    destroy,
    {0.25e-3, 0.25e-3, 0.25e-3}};
