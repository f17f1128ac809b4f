/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What acts on the bodies.
\*---------------------------------------------------------------------------*/

#include "rigidBodies.H"
#include "rotation.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Acceleration of a point at the stage
static vector stageAcceleration(const feTimeScheme& ts, const motionField& points, const label i)
{
    return points.a0[i] + ts.alphaM()*(points.a[i] - points.a0[i]);
}


//- Second moments of the mass about the centre
static tensor secondMoments(const symmTensor& J)
{
    return tensor(symmTensor(0.5*tr(J)*symmTensor::I - J));
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::rigidBodies::addInertia
(
    const label b,
    const feTimeScheme& ts,
    const vector& g,
    vector& force,
    vector& moment
) const
{
    const body& at = bodies_[b];
    const tensor arms(poseOf(b, ts).stage), E(secondMoments(at.support->inertia()));
    const vector centre(stageAcceleration(ts, points_, nPoints*b));
    force += at.support->mass()*(centre - g);
    for (label l = 0; l < 3; ++l)
    {
        const vector a((stageAcceleration(ts, points_, nPoints*b + 1 + l) - centre)/at.size);
        moment += (arms & vector(E.col(l))) ^ a;
    }
}


void Foam::rigidBodies::findSizes
(
    const fieldUnknowns& unknowns,
    const scalar time,
    const scalarField& R,
    scalar& force,
    scalar& moment
) const
{
    force = moment = 0;
    if (bodies_.empty()) return;

    // What ranks have of a node may be large where the node is in balance
    scalarField f(fe_.nNodes(), 0), sum(fe_.nNodes(), 0);
    for (label a = 0; a < fe_.dim(); ++a)
    {
        f = 0;
        for (const body& b : bodies_) for (const label n : b.nodes) f[n] = R[unknowns.start(0, n) + a];
        fe_.copies().sum(f);
        forAll(f, n) if (fe_.copies().owned(n)) sum[n] += sqr(f[n]);
    }
    for (const body& b : bodies_) forAll(b.nodes, i)
    {
        force += sum[b.nodes[i]];
        moment += sum[b.nodes[i]]*magSqr(b.arms[i]);
    }
    force = ::sqrt(returnReduce(force, sumOp<scalar>()));
    moment = ::sqrt(returnReduce(moment, sumOp<scalar>()));
    forAll(bodies_, b) forAll(directions_, k)
    {
        if (!isFree(b, k)) continue;
        scalar& size = directions_[k] < rigidSupport::ROTATION ? force : moment;
        size = max(size, mag(bodies_[b].support->value(directions_[k], time)));
    }
}


void Foam::rigidBodies::addTangent
(
    const label b,
    const feTimeScheme& ts,
    const tensor& Xf,
    const fieldUnknowns& unknowns,
    feMatrix& K
) const
{
    // Arms of the forces turn; of one rank counts what the body has itself
    const pose p(poseOf(b, ts));
    const rigidSupport& support = *bodies_[b].support;
    const scalar dDdu = ts.displacementByUnknown();
    const scalar dadu = Pstream::master() ? ts.accelerationByUnknown() : 0;
    const tensor E(secondMoments(support.inertia()));
    tensor Ea = Zero;
    if (Pstream::master() && tr(E) > 0)
    {
        const vector centre(stageAcceleration(ts, points_, nPoints*b));
        for (label l = 0; l < 3; ++l)
        {
            const vector a(stageAcceleration(ts, points_, nPoints*b + 1 + l) - centre);
            Ea += vector(E.col(l))*(a/bodies_[b].size);
        }
    }
    for (label k = 0; k < directions_.size(); ++k)
    {
        if (!isFree(b, k)) continue;
        const label col = unknown(unknowns, b, k), j = directions_[k] - rigidSupport::ROTATION;
        if (j < 0)
        {
            K.add(col, col, support.mass()*dadu);
            continue;
        }
        // sum of (dR X) x f, and of R E x dR
        const vector d
        (
          - 2*dDdu*rotation::axial(p.dR[j] & (Xf + Ea))
          - 2*dadu*rotation::axial(p.stage & E & p.dR[j].T())
        );
        for (label i = fe_.dim(); i < directions_.size(); ++i)
        {
            if (!isFree(b, i)) continue;
            K.add(unknown(unknowns, b, i), col, d[directions_[i] - rigidSupport::ROTATION]);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::rigidBodies::assemble
(
    const feTimeScheme& ts,
    const scalar time,
    const vector& g,
    const fieldUnknowns& unknowns,
    scalarField& R,
    feMatrix* K
)
{
    findSizes(unknowns, time, R, forceSize_, momentSize_);
    forAll(bodies_, b)
    {
        body& at = bodies_[b];
        const tensor arms(poseOf(b, ts).stage);
        tensor Xf = Zero;
        at.force = at.moment = Zero;
        forAll(at.nodes, n)
        {
            const vector f(unknowns.at(0, at.nodes[n], R));
            at.force += f;
            at.moment += (arms & at.arms[n]) ^ f;
            Xf += at.arms[n]*f;
        }
        if (K) addTangent(b, ts, Xf, unknowns, *K);
        if (!Pstream::master()) continue;

        vector force = Zero, moment = Zero;
        addInertia(b, ts, g, force, moment);
        forAll(directions_, k)
        {
            if (!isFree(b, k)) continue;
            const label d = directions_[k], j = d - rigidSupport::ROTATION;
            R[unknown(unknowns, b, k)] += (j < 0 ? force[d] : moment[j]) - at.support->value(d, time);
        }
    }
}


Foam::List<Foam::rigidMotion> Foam::rigidBodies::motions
(
    const feTimeScheme& ts,
    const vector& g
) const
{
    List<rigidMotion> all(bodies_.size());
    forAll(all, b)
    {
        const body& at = bodies_[b];
        rigidMotion& m = all[b];
        m.patch = at.patch;
        m.centre = at.centre + points_.D[nPoints*b];
        m.displacement = points_.D[nPoints*b];
        m.rotation = rotation::log(frame(points_.D, b));
        m.force = returnReduce(at.force, sumOp<vector>());
        m.moment = returnReduce(at.moment, sumOp<vector>());
        addInertia(b, ts, g, m.force, m.moment);
    }
    return all;
}


// ************************************************************************* //
