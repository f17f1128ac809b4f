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


// ************************************************************************* //
