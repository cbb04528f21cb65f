/* Peer: Bullet's btMultiBody, joint coordinates and Featherstone's algorithm in float64. The thread
 * is a chain of rigid links with spherical joints; bending is a torque at each joint, explicit in
 * time, as Bullet has no implicit joint springs. The body is stepped without a world: no time goes
 * into collision or islands. */
#include <cmath>
#include <new>

#include <BulletDynamics/Featherstone/btMultiBody.h>

#include "peer.h"

#if !defined(BT_USE_DOUBLE_PRECISION)
#error "the float64 build of Bullet is the one to compare with"
#endif

namespace
{

struct chain {
    explicit chain(const cantilever_setup &setup);

    btMultiBody body;
    btAlignedObjectArray<btScalar> scratch_r; /* Bullet sizes them in the first step */
    btAlignedObjectArray<btVector3> scratch_v;
    btAlignedObjectArray<btMatrix3x3> scratch_m;
    double length; /* of a link, m */
    double dt;
    double kick;        /* the time over which the next step accelerates */
    double drag_change; /* relative change of the velocities in a step */
};

/* The held first segment is the base: node 1 is the first joint, and link i ends at node i + 2. */
chain::chain(const cantilever_setup &setup)
    : body((int)setup.segments - 1, 0.0, btVector3(0, 0, 0), true, false),
      length(CANTILEVER_LENGTH / (setup.segments - 0.5)), dt(setup.dt),
      /* Half a kick at first puts the velocities between the steps: leapfrog, of second order. */
      kick(0.5 * setup.dt),
      /* Drag proportional to mass decays all velocities alike, joint velocities included. */
      drag_change(std::expm1(-setup.drag * setup.dt))
{
    int links = body.getNumLinks();
    const btQuaternion straight(0, 0, 0, 1);
    body.setBasePos(btVector3(0.5 * length, 0, 0));
    for (int i = 0; i < links; i++) {
        double mass = CANTILEVER_LINEAR_DENSITY * length * (i + 1 < links ? 1.0 : 0.5);
        /* A point mass at the far end lets the step be the largest. Inertia about the link's own
         * axis takes no part in the motion, it keeps the twist from limiting the step. */
        const btVector3 inertia(mass * length * length, 0, 0);
        body.setupSpherical(i, mass, inertia, i - 1, straight, btVector3(0, 0, 0),
                            btVector3(length, 0, 0));
    }
    body.finalizeMultiDof();
    body.setLinearDamping(0);
    body.setAngularDamping(0);
    body.setMaxCoordinateVelocity(1e9);
    for (int i = 0; i < links; i++) { /* stays until cleared, which nobody does */
        body.addLinkForce(i, btVector3(0, -CANTILEVER_GRAVITY * body.getLinkMass(i), 0));
    }
}

void *create(const cantilever_setup *setup)
{
    return setup->segments < 3 ? nullptr : new (std::nothrow) chain(*setup);
}

/* Torque -EI/l times the rotation vector of each joint: the energy of the angle, EI/2l angle^2. */
void set_joint_torques(chain &c)
{
    double stiffness = CANTILEVER_BENDING_STIFFNESS / c.length;
    for (int i = 0; i < c.body.getNumLinks(); i++) {
        const btScalar *q = c.body.getJointPosMultiDof(i); /* x, y, z, w */
        btScalar *torque = c.body.getJointTorqueMultiDof(i);
        double w = std::fabs(q[3]), s = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2]);
        double scale = s > 1e-9 ? 2.0 * std::atan2(s, w) / s : 2.0;
        scale *= q[3] < 0.0 ? stiffness : -stiffness;
        for (int k = 0; k < 3; k++) {
            torque[k] = scale * q[k];
        }
    }
}

int step(void *thread)
{
    chain &c = *static_cast<chain *>(thread);
    set_joint_torques(c);
    c.body.computeAccelerationsArticulatedBodyAlgorithmMultiDof(c.kick, c.scratch_r, c.scratch_v,
                                                                c.scratch_m, false, false, false);
    c.kick = c.dt;
    if (c.drag_change != 0.0) {
        c.body.applyDeltaVeeMultiDof(c.body.getVelocityVector(), c.drag_change);
    }
    c.body.stepPositionsMultiDof(c.dt);
    const btScalar *q = c.body.getJointPosMultiDof(0);
    return std::isfinite(q[0] + q[1] + q[2] + q[3]) ? 0 : 1;
}

void tip(void *thread, double tip[3])
{
    chain &c = *static_cast<chain *>(thread);
    /* The last link's origin is its mass, which is at its end. */
    btVector3 end = c.body.localPosToWorld(c.body.getNumLinks() - 1, btVector3(0, 0, 0));
    for (int k = 0; k < 3; k++) {
        tip[k] = end[k];
    }
}

double stretch(void *)
{
    return 0.0;
}

void destroy(void *thread)
{
    delete static_cast<chain *>(thread);
}

} /* namespace */

/* By bisection; unstable at 1 ms (in the whip after 0.1 s; at 1.04 ms at once), 254, 64.4 and 16.3
 * us. The limit is 2 / omega, omega = 4/l^2 sqrt(EI / linear density). */
const cantilever_method cantilever_bullet_multibody = {
    "bullet-multibody",
    "Bullet " PEER_TEXT(BT_BULLET_VERSION) " btMultiBody, float64: rigid links, spherical joints,"
                                           " torque EI/l * angle explicit in time",
    create,
    step,
    tip,
    stretch,
    destroy,
    {1e-3 / 1.1, 250e-6, 62.5e-6, 15.625e-6}};
