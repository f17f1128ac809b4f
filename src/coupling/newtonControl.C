/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "newtonControl.H"
#include "unknownEntries.H"
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static const newtonControl::way fullSteps{"full steps", 1, false, 1, 0};
static const newtonControl::way fallBacks[] =
    {{"lineSearch", 1, true, 1, 0}, {"relaxation", 0.5, true, 3, 0}, newtonControl::pseudoStep};

} // End namespace Foam


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::newtonControl::way Foam::newtonControl::pseudoStep{"pseudoTransient", 1, false, 0.5, 0.1};


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

const char* Foam::newtonControl::outcomeName(const label o)
{
    static const char* names[] =
    {
        "converged", "maxIterations", "diverged", "notFinite", "invertedElement", "singular",
        "outOfMemory", "linearSolver"
    };
    return names[o];
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::newtonControl::newtonControl(const dictionary& dict)
:
    tolerance_(dict.lookupOrDefault<scalar>("tolerance", 1e-8)),
    maxIter_(dict.lookupOrDefault<label>("maxIter", 20)),
    relaxation_(dict.lookupOrDefault<scalar>("relaxation", 1)),
    linearTolerance_(dict.lookupOrDefault<scalar>("linearTolerance", 1e-3)),
    ways_({fullSteps}),
    way_(fullSteps),
    iteration_(-1),
    norm_(GREAT),
    firstNorm_(GREAT),
    least_(GREAT),
    leastAt_(0),
    nGrowths_(0),
    minDetJ_(GREAT),
    outcome_(CONVERGED)
{
    reportUnknownEntries(dict, {"tolerance", "maxIter", "relaxation", "linearTolerance", "fallBack", "tangent"});
    wordList names;
    for (const way& w : fallBacks) names.append(w.name);
    for (const word& name : dict.lookupOrDefault("fallBack", names))
    {
        if (!names.found(name))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown way '" << name << "' in fallBack, expected a list of some of " << names
                << exit(FatalIOError);
        }
        ways_.append(fallBacks[names.find(name)]);
    }
    if
    (
        !(tolerance_ > 0 && tolerance_ < 1) || maxIter_ < 1 || !(relaxation_ > 0 && relaxation_ <= 1)
     || !(linearTolerance_ > 0 && linearTolerance_ < 1)
    )
    {
        FatalIOErrorInFunction(dict)
            << "Found tolerance " << tolerance_ << ", maxIter " << maxIter_
            << ", relaxation " << relaxation_ << ", linearTolerance "
            << linearTolerance_ << "; expected 0 < tolerance < 1, maxIter >= 1,"
            << " 0 < relaxation <= 1, 0 < linearTolerance < 1"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::newtonControl::start(const way& w, const scalar patience)
{
    way_ = w;
    way_.patience *= patience;
    nGrowths_ = 0;
    iteration_ = -1;
    norm_ = GREAT;
    outcome_ = CONVERGED;
}


bool Foam::newtonControl::tooFar(const scalar norm, const scalar minDetJ) const
{
    return
        !(minDetJ > 0) || !std::isfinite(norm)
     || (way_.search && norm > max(norm_, tolerance_));
}


bool Foam::newtonControl::mayTurn() const
{
    // A start that is of no worth is that of all ways
    return iteration_ > 0 && outcome_ < SINGULAR;
}


bool Foam::newtonControl::loop(const scalar norm, const bool nil, const scalar minDetJ)
{
    ++iteration_;
    if (iteration_ == 0) firstNorm_ = norm;
    nGrowths_ = iteration_ > 0 && norm > max(norm_, firstNorm_) ? nGrowths_ + 1 : 0;
    norm_ = norm;
    minDetJ_ = minDetJ;
    if (iteration_ == 0 || norm < least_)
    {
        least_ = norm;
        leastAt_ = iteration_;
    }
    const bool stalls = way_.relaxation < 1 && iteration_ - leastAt_ >= maxIter_;

    if (outcome_ != CONVERGED) return false;
    if (minDetJ <= 0) outcome_ = INVERTED_ELEMENT;
    else if (!std::isfinite(norm) || !std::isfinite(minDetJ)) outcome_ = NOT_FINITE;
    else if (norm > 1e8*max(firstNorm_, 1.0) || nGrowths_ == 5) outcome_ = DIVERGED;
    else if (norm <= max(tolerance_, way_.enough*firstNorm_) && (nil || iteration_ > 0)) return false;
    else if (iteration_ >= maxIter_*way_.patience || stalls) outcome_ = MAX_ITERATIONS;

    return ok();
}


const char* Foam::newtonControl::advice() const
{
    switch (outcome_)
    {
        case INVERTED_ELEMENT:
            return
                "In a fluid the mesh has no room for this motion: another stiffness of the mesh"
                " motion or a mesh with more room there may help. In a solid a finer mesh,"
                " another element or a stiffer material where it is squeezed may.";
        case OUT_OF_MEMORY:
            return "The factors do not fit into the memory: use more ranks or a coarser mesh.";
        case SINGULAR:
            return "See the message on the singular matrix above.";
        case NOT_FINITE:
            return
                "A load, a boundary value, a material or the mesh gives no finite number there:"
                " check the functions of time and space that it has.";
        default:
            return
                "Check the units of loads and materials there, and whether a load jumps: a ramp,"
                " or its time in timeStepControl { times (...); }, may help.";
    }
}


Foam::scalar Foam::newtonControl::linearTolerance() const
{
    // Small beside the scale, but not yet answered
    if (norm_ <= tolerance_) return 1e-6;

    // Where the next residual would be near its goal, go there at once
    const scalar tolerance = min(linearTolerance_, norm_);
    const scalar enough = min(linearTolerance_, 0.3*tolerance_/norm_);
    return tolerance*norm_ > 100*tolerance_ ? tolerance : enough;
}


// ************************************************************************* //
