/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "newtonControl.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::newtonControl::newtonControl(const dictionary& dict)
:
    tolerance_(dict.lookupOrDefault<scalar>("tolerance", 1e-8)),
    maxIter_(dict.lookupOrDefault<label>("maxIter", 20)),
    relaxation_(dict.lookupOrDefault<scalar>("relaxation", 1)),
    linearTolerance_(dict.lookupOrDefault<scalar>("linearTolerance", 1e-3)),
    iteration_(-1),
    norm_(GREAT),
    firstNorm_(GREAT),
    outcome_(feRegion::CONVERGED)
{
    if
    (
        !(tolerance_ > 0) || maxIter_ < 1 || !(relaxation_ > 0 && relaxation_ <= 1)
     || !(linearTolerance_ > 0 && linearTolerance_ < 1)
    )
    {
        FatalIOErrorInFunction(dict)
            << "Found tolerance " << tolerance_ << ", maxIter " << maxIter_
            << ", relaxation " << relaxation_ << ", linearTolerance "
            << linearTolerance_ << "; expected tolerance > 0, maxIter >= 1,"
            << " 0 < relaxation <= 1, 0 < linearTolerance < 1"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::newtonControl::start()
{
    iteration_ = -1;
    norm_ = GREAT;
    outcome_ = feRegion::CONVERGED;
}


bool Foam::newtonControl::loop(const scalar norm, const scalar minDetJ)
{
    ++iteration_;
    norm_ = norm;
    if (iteration_ == 0) firstNorm_ = norm;

    if (outcome_ != feRegion::CONVERGED) return false;
    if (!(minDetJ > 0)) outcome_ = feRegion::INVERTED_ELEMENT;
    else if (!std::isfinite(norm) || norm > 1e8*max(firstNorm_, 1.0)) outcome_ = feRegion::DIVERGED;
    else if (norm <= tolerance_) return false;
    else if (iteration_ >= maxIter_) outcome_ = feRegion::MAX_ITERATIONS;

    return ok();
}


Foam::scalar Foam::newtonControl::linearTolerance() const
{
    // Where the next residual would be near its goal, go there at once
    const scalar tolerance = min(linearTolerance_, norm_);
    const scalar enough = min(linearTolerance_, 0.3*tolerance_/norm_);
    return tolerance*norm_ > 100*tolerance_ ? tolerance : enough;
}


// ************************************************************************* //
