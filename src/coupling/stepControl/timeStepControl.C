/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timeStepControl.H"
#include "addToRunTimeSelectionTable.H"
#include "readNumber.H"
#include "unknownEntries.H"
#include "ListOps.H"

namespace Foam
{
    defineTypeNameAndDebug(timeStepControl, 0);
    defineRunTimeSelectionTable(timeStepControl, dictionary);
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static scalar optionalNumber
(
    const dictionary& dict,
    const word& keyword,
    const dimensionSet& dimensions,
    const scalar low,
    const scalar high,
    const scalar absent
)
{
    return dict.found(keyword) ? readNumber(dict, keyword, dimensions, low, high) : absent;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::timeStepControl::timeStepControl(const dictionary& dict)
:
    minDeltaT_(optionalNumber(dict, "minDeltaT", dimTime, 0, GREAT, 0)),
    times_(dict.lookupOrDefault("times", scalarList()))
{
    sort(times_);
}


Foam::autoPtr<Foam::timeStepControl> Foam::timeStepControl::New(const dictionary& dict)
{
    const word type(dict.lookupOrDefault<word>("type", "fixed"));
    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);
    if (!cstrIter.found())
    {
        FatalIOErrorInLookup
        (
            dict, "timeStepControl", type, *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }
    return cstrIter()(dict);
}


// * * * * * * * * * * * * * * * * * Models  * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace timeStepControls
{

//- deltaT of controlDict
class fixed : public timeStepControl
{
public:

    TypeName("fixed");

    explicit fixed(const dictionary& dict)
    :
        timeStepControl(dict)
    {
        reportUnknownEntries(dict, {"type", "minDeltaT", "times"});
    }

    virtual bool keepsPace() const { return true; }
    virtual scalar maxGrowth() const { return 2; }
    virtual scalar maxDeltaT(const scalar controlDeltaT) const { return controlDeltaT; }

    virtual stepSize next
    (
        const scalar, const label, const scalar, const scalar controlDeltaT
    ) const
    {
        return {controlDeltaT, "deltaT"};
    }
};


//- By the number of iterations, and the error
class automatic : public timeStepControl
{
    const scalar maxDeltaT_, maxGrowth_, target_, errorTolerance_;

public:

    TypeName("automatic");

    explicit automatic(const dictionary& dict)
    :
        timeStepControl(dict),
        maxDeltaT_(readNumber(dict, "maxDeltaT", dimTime, 0, GREAT)),
        maxGrowth_(optionalNumber(dict, "maxGrowth", dimless, 1, 10, 1.5)),
        target_(optionalNumber(dict, "targetIterations", dimless, 1, 1000, 5)),
        errorTolerance_(optionalNumber(dict, "errorTolerance", dimless, 0, 1, 0))
    {
        reportUnknownEntries
        (
            dict,
            {
                "type", "minDeltaT", "times", "maxDeltaT", "maxGrowth", "targetIterations",
                "errorTolerance"
            }
        );
        if (minDeltaT(0) > maxDeltaT_)
        {
            FatalIOErrorInFunction(dict)
                << "minDeltaT " << minDeltaT(0) << " is larger than maxDeltaT " << maxDeltaT_
                << exit(FatalIOError);
        }
    }

    virtual bool keepsPace() const { return false; }
    virtual scalar maxGrowth() const { return maxGrowth_; }
    virtual scalar maxDeltaT(const scalar) const { return maxDeltaT_; }
    virtual bool wantsError() const { return errorTolerance_ > 0; }

    virtual stepSize next
    (
        const scalar deltaT, const label nIterations, const scalar error, const scalar
    ) const
    {
        stepSize size{deltaT*target_/max(nIterations, 1), "iterations"};
        if (wantsError() && error > 0)
        {
            // Not less than half: a jump of the step excites what it cannot resolve
            size.limit(deltaT*max(0.9*::sqrt(errorTolerance_/error), scalar(0.5)), "error");
        }
        return size;
    }
};


defineTypeNameAndDebug(fixed, 0);
defineTypeNameAndDebug(automatic, 0);
addToRunTimeSelectionTable(timeStepControl, fixed, dictionary);
addToRunTimeSelectionTable(timeStepControl, automatic, dictionary);

} // End namespace timeStepControls
} // End namespace Foam


// ************************************************************************* //
