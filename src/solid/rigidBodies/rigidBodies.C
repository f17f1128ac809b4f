/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rigidBodies.H"
#include "rotation.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Derivative of a node's displacement at the end of the step after its unknown
static scalar endByUnknown(const feTimeScheme& ts)
{
    return ts.displacementByUnknown()/ts.alphaF();
}


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

bool Foam::rigidBodies::turns(const label b) const
{
    for (label k = fe_.dim(); k < directions_.size(); ++k) if (isFree(b, k)) return true;
    return false;
}


Foam::label Foam::rigidBodies::unknown
(
    const fieldUnknowns& unknowns,
    const label b,
    const label k
) const
{
    const label dim = fe_.dim();
    return k < dim ? unknowns.start(field_, b) + k : unknowns.start(field_ + 1, b) + k - dim;
}


Foam::scalar Foam::rigidBodies::motion
(
    const label b,
    const label direction,
    const scalar t
) const
{
    const scalar value = bodies_[b].support->value(direction, t);
    if (value == 0 || directions_.found(direction)) return value;
    FatalErrorInFunction
        << "rigidPatch " << bodies_[b].patch << " of region " << fe_.mesh().name()
        << " has a motion " << value << " in a direction that a 2-D case has not"
        << exit(FatalError);
    return 0;
}


Foam::tensor Foam::rigidBodies::frame(const vectorField& D, const label b) const
{
    const label c = nPoints*b;
    const auto along = [&](const label k)
    {
        return vector(rotation::axis(k) + (D[c + 1 + k] - D[c])/bodies_[b].size);
    };
    return rotation::orthonormal(tensor(along(0), along(1), along(2), true));
}


Foam::rigidBodies::pose Foam::rigidBodies::poseOf(const label b, const feTimeScheme& ts) const
{
    pose p;
    p.R0 = frame(points_.D0, b);
    p.R = frame(points_.D, b);
    p.stage = p.R0 + ts.alphaF()*(p.R - p.R0);
    p.w = rotation::log(p.R & p.R0.T());
    for (label j = 0; j < 3; ++j) p.dR[j] = rotation::dexp(p.w, j) & p.R0;
    return p;
}


void Foam::rigidBodies::place
(
    const label b,
    const vector& d,
    const tensor& R,
    const feTimeScheme& ts,
    motionField& nodes
)
{
    const body& at = bodies_[b];
    const tensor turn(R - tensor::I);
    for (label k = 0; k < nPoints; ++k)
    {
        const vector arm(k > 0 ? vector(at.size*rotation::axis(k - 1)) : vector::zero);
        points_.setD(ts, nPoints*b + k, d + (turn & arm));
    }
    forAll(at.nodes, i) nodes.setD(ts, at.nodes[i], d + (turn & at.arms[i]));
}


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

bool Foam::rigidBodies::turn() const
{
    forAll(bodies_, b) if (turns(b)) return true;
    return false;
}


void Foam::rigidBodies::constrain
(
    const fieldUnknowns& unknowns,
    const feTimeScheme& ts,
    dofConstraints& c
) const
{
    forAll(bodies_, b)
    {
        const body& at = bodies_[b];
        const pose p(poseOf(b, ts));
        labelList column(directions_.size());
        forAll(column, k)
        {
            column[k] = unknown(unknowns, b, k);
            if (!isFree(b, k)) c.fix(column[k]);
        }
        forAll(at.nodes, n) for (label a = 0; a < fe_.dim(); ++a)
        {
            const label cmpt = fe_.axis(a);
            DynamicList<dofConstraints::term> row;
            forAll(directions_, k)
            {
                const label j = directions_[k] - rigidSupport::ROTATION;
                if (!isFree(b, k)) continue;
                if (k == a) row.append(dofConstraints::term(column[k], 1));
                if (j < 0) continue;
                const vector spin(rotation::axis(j) ^ (p.stage & at.arms[n]));
                row.append(dofConstraints::term(column[k], (p.dR[j] & at.arms[n])[cmpt], spin[cmpt]));
            }
            c.tie(unknowns.start(0, at.nodes[n]) + a, row);
        }
    }
}


void Foam::rigidBodies::predict
(
    const feTimeScheme& ts,
    const scalar time,
    motionField& nodes
)
{
    forAll(bodies_, b) agree(b, nodes, ts.deltaT());
    points_.predict(ts);
    forAll(bodies_, b)
    {
        // As the points are predicted to move, then as the motions are given
        const label c = nPoints*b;
        const tensor R0(frame(points_.D0, b));
        const vectorField move(points_.D - points_.D0);
        vector d(points_.D[c]), w(Zero), angle(Zero);
        for (label k = 0; k < 3; ++k)
        {
            w += 0.5*(vector(R0.col(k)) ^ (move[c + 1 + k] - move[c]))/bodies_[b].size;
        }
        for (label k = 0; k < 3; ++k)
        {
            const label turn = rigidSupport::ROTATION + k;
            if (!bodies_[b].support->isFree(k)) d[k] = motion(b, k, time);
            if (bodies_[b].support->isFree(turn)) continue;
            angle[k] = motion(b, turn, time);
            w[k] = angle[k] - motion(b, turn, time - ts.deltaT());
        }
        place(b, d, turns(b) ? rotation::exp(w) & R0 : rotation::exp(angle), ts, nodes);
    }
}


void Foam::rigidBodies::update
(
    const feTimeScheme& ts,
    const fieldUnknowns& unknowns,
    const scalarField& dx,
    motionField& nodes
)
{
    forAll(bodies_, b)
    {
        const pose p(poseOf(b, ts));
        vector d(points_.D[nPoints*b]), w(p.w);
        forAll(directions_, k)
        {
            if (!isFree(b, k)) continue;
            const scalar move = endByUnknown(ts)*dx[unknown(unknowns, b, k)];
            const label j = directions_[k] - rigidSupport::ROTATION;
            if (j < 0) d[directions_[k]] += move;
            else w[j] += move;
        }
        place(b, d, turns(b) ? rotation::exp(w) & p.R0 : p.R, ts, nodes);
    }
}


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
