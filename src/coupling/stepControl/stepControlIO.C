/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What the step control remembers from one run to the next, and what it says.
\*---------------------------------------------------------------------------*/

#include "stepControl.H"
#include "fourDigits.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- As 2 d 03 h, 1 h 04 min, 5 min 06 s, 7 s
static string duration(const scalar seconds)
{
    const long s = std::lround(seconds);
    const auto two = [](const long major, const char* a, const long minor, const char* b)
    {
        char text[64];
        std::snprintf(text, sizeof text, "%ld %s %02ld %s", major, a, minor, b);
        return string(text);
    };
    if (s >= 86400) return two(s/86400, "d", s % 86400/3600, "h");
    if (s >= 3600) return two(s/3600, "h", s % 3600/60, "min");
    if (s >= 60) return two(s/60, "min", s % 60, "s");
    return std::to_string(s) + " s";
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class M, class F>
void Foam::stepControl::forEntries(M& m, const F& f)
{
    f("controlDeltaT", m.controlDeltaT);
    f("deltaT", m.deltaT);
    f("wait", m.wait);
    f("patience", m.patience);
    f("failed", m.failed);
    f("pace", m.pace);
}


void Foam::stepControl::readMemory()
{
    if (!empty())
    {
        forEntries(memory_, [&](const char* name, scalar& s) { s = get<scalar>(name); });
        limitedBy_ = get<word>("limitedBy");
    }
    readControlDeltaT();
}


void Foam::stepControl::readControlDeltaT()
{
    const dictionary& dict = runTime_.controlDict();
    const bool isStatic = staticStage_.has(runTime_.value());
    const scalar deltaT = isStatic ? staticStage_.deltaT() : dict.get<scalar>("deltaT");
    if (!(deltaT > 0 && deltaT < GREAT))
    {
        FatalIOErrorInFunction(dict)
            << "deltaT is " << deltaT << ", expected a number > 0" << exit(FatalIOError);
    }
    if (deltaT == memory_.controlDeltaT) return;
    if (memory_.controlDeltaT > 0)
    {
        Info<< "deltaT of " << (isStatic ? "staticStage" : "controlDict") << " is now " << deltaT << " and was "
            << memory_.controlDeltaT << ": the next step has it" << nl;
    }
    memory_ = {deltaT, min(deltaT, control_->maxDeltaT(deltaT))};
    limitedBy_ = memory_.deltaT < deltaT ? "maxDeltaT" : "deltaT";
}


Foam::scalar Foam::stepControl::timeLeft() const
{
    const scalar done = runTime_.value() - firstTime_;
    const scalar left = runTime_.endTime().value() - runTime_.value();
    return done > 0 ? max(left, scalar(0))*clock_.elapsed()/done : 0;
}


void Foam::stepControl::report(const label nIterations) const
{
    Info<< "Step " << runTime_.timeIndex() << ": deltaT " << fourDigits(size_.deltaT) << " by "
        << size_.by << ", " << nIterations << " iterations";
    const scalar end = runTime_.endTime().value(), start = runTime_.startTime().value();
    if (end < GREAT && end > start)
    {
        Info<< "; " << fourDigits(100*min((runTime_.value() - start)/(end - start), scalar(1)))
            << " % done, " << duration(timeLeft()).c_str() << " left";
    }
    if (nRepeats_)
    {
        Info<< "; " << nRepeats_ << " repeated, last for " << lastRepeat_.c_str();
    }
    Info<< nl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::stepControl::writeData(Ostream& os) const
{
    const auto digits = os.precision(17);
    forEntries(memory_, [&](const char* name, const scalar s) { os.writeEntry(name, s); });
    os.writeEntry("limitedBy", limitedBy_);
    os.precision(digits);
    return os.good();
}


// ************************************************************************* //
