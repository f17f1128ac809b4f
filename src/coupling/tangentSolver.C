/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tangentSolver.H"
#include "readNumber.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::tangentSolver::mode> Foam::tangentSolver::modes
({
    {mode::AUTOMATIC, "automatic"}, {mode::EXACT, "exact"}, {mode::KRYLOV, "Krylov"}, {mode::ANDERSON, "Anderson"}
});


// * * * * * * * * * * * * * * * factorPolicy * * * * * * * * * * * * * * * * //

void Foam::factorPolicy::made(const scalar nFlops, const scalar nNonzeros)
{
    has = true;
    making = nFlops/(20*max(nNonzeros, 1.0));
    total = making;
    uses = 0;
}


void Foam::factorPolicy::used(const label n)
{
    total += n;
    ++uses;
    if (uses > 1 && n > total/uses) has = false;
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Each iteration keeps two vectors
static label readMaxIter(const dictionary& dict)
{
    const scalar n = readNumber(dict, "maxIter", dimless, 0, 1001);
    if (n == floor(n)) return label(n);
    FatalIOErrorInFunction(dict)
        << "maxIter is " << n << ", expected a whole number" << exit(FatalIOError);
    return 0;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tangentSolver::outcome Foam::tangentSolver::from
(
    const feLinearSolver::outcome o
)
{
    switch (o)
    {
        case feLinearSolver::outcome::OK:            return outcome::OK;
        case feLinearSolver::outcome::SINGULAR:      return outcome::SINGULAR;
        case feLinearSolver::outcome::OUT_OF_MEMORY: return outcome::OUT_OF_MEMORY;
        default:                                     return outcome::FAILED;
    }
}


Foam::tangentSolver::outcome Foam::tangentSolver::factorise(systemTimes& times)
{
    systemTimes::timer timer(times, systemTimes::FACTORISATION);
    const outcome o = from(factors_->factorise());
    if (o != outcome::OK)
    {
        drop();
        return o;
    }
    policy_.made(solver().stats().nFlops, solver().stats().nNonzeros);
    ++nFactorisations_;
    ++times.nFactorisations;
    return o;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::tangentSolver::tangentSolver
(
    const nodeMap& map,
    const dofConstraints& constraints,
    const UPtrList<elementScatter>& scatter,
    const dictionary& dict,
    const mode m
)
:
    map_(map),
    constraints_(constraints),
    K_(new feMatrix(map, map, &constraints, scatter)),
    factors_(new feFactors(map, K_(), dict)),
    gmres_(map, dict.found("maxIter") ? readMaxIter(dict) : 60),
    mode_(m),
    anderson_(map),
    nFixed_(0),
    before_(GREAT),
    nFactorisations_(0),
    nIterations_(-1)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tangentSolver::outcome Foam::tangentSolver::remake
(
    const factorPolicy& policy,
    systemTimes& times
)
{
    const outcome o = factorise(times);
    if (o == outcome::OK) policy_ = policy;
    return o;
}


void Foam::tangentSolver::start()
{
    anderson_.clear();
    nFixed_ = 0;
    before_ = GREAT;
}


bool Foam::tangentSolver::wantsMatrix(const scalar norm)
{
    if (mode_ != mode::ANDERSON) return true;

    // New factors where six iterations have not brought a tenth
    if (nFixed_ % 6 == 0)
    {
        if (nFixed_ && norm > 0.1*before_) drop();
        before_ = norm;
    }
    return !policy_.has;
}


Foam::tangentSolver::outcome Foam::tangentSolver::solveByAnderson
(
    const scalarField& R,
    const scalarField& rowScale,
    scalarField& dx,
    systemTimes& times
)
{
    if (!policy_.has)
    {
        const outcome made = factorise(times);
        if (made != outcome::OK) return made;
        start();
    }
    systemTimes::timer timer(times, systemTimes::SOLVE);
    b_ = -R;
    y_.setSize(map_.nUnknowns());
    const outcome result = from(factors_->solve(b_, y_));
    constraints_.distribute(y_);
    anderson_.next(R, y_, rowScale, dx);
    ++nFixed_;
    nIterations_ = 1;
    ++times.nLinear;
    return result;
}


Foam::tangentSolver::outcome Foam::tangentSolver::solve
(
    const action& A,
    const scalarField& R,
    const scalarField& rowScale,
    const scalar tolerance,
    scalarField& dx,
    systemTimes& times
)
{
    if (mode_ == mode::ANDERSON) return solveByAnderson(R, rowScale, dx, times);
    if (mode_ == mode::EXACT) drop();

    outcome result = outcome::OK;
    const auto scaledA = [&](const scalarField& x, scalarField& y)
    {
        A(x, y);
        y *= rowScale;
    };
    const auto Minv = [&](const scalarField& y, scalarField& x)
    {
        y_ = y/rowScale;
        const outcome o = from(factors_->solve(y_, x));
        if (o != outcome::OK) result = o;
        constraints_.distribute(x);
    };
    const auto iterate = [&](const label limit)
    {
        systemTimes::timer timer(times, systemTimes::SOLVE);
        b_ = -R*rowScale;
        return gmres_.solve(scaledA, Minv, b_, dx, tolerance, limit);
    };

    bool fresh = false;
    if (!policy_.has)
    {
        result = factorise(times);
        if (result != outcome::OK) return result;
        fresh = true;
    }

    label limit = fresh || mode_ == mode::KRYLOV ? gmres_.maxIter() : policy_.limit(gmres_.maxIter());
    nIterations_ = iterate(limit);
    if (nIterations_ > limit && !fresh)
    {
        result = factorise(times);
        if (result != outcome::OK) return result;
        limit = gmres_.maxIter();
        nIterations_ = iterate(limit);
    }
    if (result != outcome::OK) return result;
    if (mode_ != mode::KRYLOV) policy_.used(nIterations_);
    times.nLinear += nIterations_;
    return nIterations_ > limit ? outcome::STALLED : outcome::OK;
}


// ************************************************************************* //
