/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nodalMotion.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::nodalMotion::factorise(const vectorField& u)
{
    const bool updated = updates_ || kappa_.empty();
    if (updated) kappa_ = stiffness_->elements(fe_.points() + u);
    const vectorField x(incremental_ ? fe_.points() + u : tmp<vectorField>(fe_.points()));
    for (problem& p : problems_)
    {
        p.K->clear();
        assemble(p.K(), x, u);
        if (p.factors->factorise() == feLinearSolver::outcome::OK) continue;
        FatalIOErrorInFunction(dict_)
            << "The mesh motion of region " << fe_.mesh().name()
            << " cannot be solved: no patch holds its displacement"
            << exit(FatalIOError);
    }
    at_ = u;
}


void Foam::nodalMotion::makeOffset(problem& p, const vectorField& u0)
{
    p.f.setSize(p.x.size());
    for (scalarField& f : p.f) f.setSize(map_->nUnknowns());
    forAll(u0, n) forCmpts(p, n, [&](const label c, const label r, const label i) { p.x[r][i] = u0[n][c]; });
    forAll(p.f, r)
    {
        // At tied unknowns what they have beyond their masters' part
        const scalarField values(p.x[r]);
        p.constraints->imposeHomogeneous(p.x[r]);
        for (const label i : p.constraints->slaves()) p.x[r][i] = values[i] - p.x[r][i];
        p.K->multiply(p.x[r], p.f[r]);
    }
    if (nonlinear())
    {
        scalarField R(map_->nUnknowns(), 0);
        addResidual(u0, R);
        p.constraints->condense(R);
        p.f[0] -= R;
    }
    for (scalarField& f : p.f) map_->sum(f);
}


bool Foam::nodalMotion::solve(vectorField& u, const bool affine) const
{
    for (const problem& p : problems_) if (!solve(p, u, affine)) return false;
    return true;
}


bool Foam::nodalMotion::solve(const problem& p, vectorField& u, const bool affine) const
{
    // K x = f with what is known of x on the right: values that are given, and
    // what ties add to their masters'
    const dofConstraints& constraints = p.constraints();
    for (scalarField& x : p.x)
    {
        x = 0;
        if (affine) for (const label i : constraints.slaves()) x[i] = constraints.b(i);
    }
    const auto give = [&]()
    {
        forAll(u, n) forCmpts(p, n, [&](const label c, const label r, const label i)
        {
            if (constraints.isGiven(i)) p.x[r][i] = u[n][c];
        });
    };
    give();
    forAll(p.x, r)
    {
        scalarField& b = p.b[r];
        p.K->multiply(p.x[r], b);
        map_->sum(b);
        forAll(b, i) b[i] = constraints.isFree(i) ? -b[i] : 0;
        if (affine && p.f.size()) forAll(b, i) if (constraints.isFree(i)) b[i] += p.f[r][i];
    }
    if (p.factors->solve(p.b, p.x) != feLinearSolver::outcome::OK) return false;

    give();
    for (scalarField& x : p.x) affine ? constraints.impose(x) : constraints.imposeHomogeneous(x);
    forAll(u, n) forCmpts(p, n, [&](const label c, const label r, const label i) { u[n][c] = p.x[r][i]; });
    return true;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::nodalMotion::given(const label node) const
{
    bool all = true;
    for (const problem& p : problems_) forCmpts(p, node, [&](const label, const label, const label u)
    {
        all = all && p.constraints->isGiven(u);
    });
    return all;
}


void Foam::nodalMotion::renew()
{
    // Without ties there is nothing to renew
    if (layout_->nComponents(0) == 1) return;
    problem& p = problems_[0];
    const bool kept = constrain(p.constraints());
    if (!curved_) return;

    // The rows' weights are others
    if (!kept) makeMatrix(p);
    factorise(vectorField(at_));
    if (incremental_ || nonlinear()) makeOffset(p, at_);
}


Foam::List<const Foam::feLinearSolver*> Foam::nodalMotion::solvers() const
{
    List<const feLinearSolver*> all(problems_.size());
    forAll(all, p) all[p] = &problems_[p].factors->solver();
    return all;
}


void Foam::nodalMotion::adapt(const vectorField& u)
{
    if (!hasSteps()) return;
    if (returnReduce(u != at_, orOp<bool>())) factorise(u);
    if (incremental_ || nonlinear()) for (problem& p : problems_) makeOffset(p, u);
}


void Foam::nodalMotion::settle(vectorField& u) const
{
    if (!curved_) return;

    // Newton's method, by node
    const scalar t = fe_.mesh().time().timeOutputValue();
    bool moved = true;
    for (label k = 0; moved && k < 20; ++k)
    {
        fe_.toPoints<vector>(u, field_->primitiveFieldRef());
        moved = returnReduce(boundary_->project(u, t), orOp<bool>());
    }
}


// ************************************************************************* //
