/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stepControl.H"
#include "stopSignals.H"
#include "fourDigits.H"
#include "OStringStream.H"
#include "subDictOrEmpty.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Round-off of a time, as a part of a step
static const scalar smallPart = 1e-9;


//- A time in twelve digits: the same whatever it has been computed from
static scalar rounded(const scalar t)
{
    return std::stod(Time::timeName(t, 12));
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::stepControl::nextWriteTime() const
{
    const dictionary& dict = runTime_.controlDict();
    const word control(dict.lookupOrDefault<word>("writeControl", "timeStep"));
    if (control != "adjustableRunTime" && control != "adjustable") return GREAT;
    const scalar interval = dict.get<scalar>("writeInterval");
    const scalar start = runTime_.startTime().value();
    const scalar n = std::floor((start_.value() - start)/interval + smallPart);
    return rounded(start + (n + 1)*interval);
}


void Foam::stepControl::choose()
{
    size_ = {memory_.deltaT, limitedBy_};
    meets_ = -GREAT;
    const scalar t = start_.value(), dt = size_.deltaT;

    scalar next = GREAT;
    word by;
    const auto meet = [&](const scalar time, const word& name)
    {
        if (time - t <= smallPart*dt || time >= next) return;
        next = time;
        by = name;
    };
    meet(memory_.pace, "pace");
    meet(nextWriteTime(), "writeTime");
    for (const scalar time : control_->times()) meet(time, "times");
    meet(staticStage_.endTime(), "staticStage");
    if (!control_->keepsPace() || size_.by != "deltaT") meet(runTime_.endTime().value(), "endTime");

    // At once, or by two steps of the same length
    const scalar left = next - t;
    if (left >= 2*(1 - smallPart)*dt) return;
    const bool atOnce = left <= (1 + smallPart)*dt;
    if (atOnce) meets_ = next;
    if (mag(left - dt) > smallPart*dt) size_ = {atOnce ? left : 0.5*left, by};
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stepControl::stepControl(Time& runTime, const dictionary& solution)
:
    IOdictionary
    (
        IOobject
        (
            "stepControl", runTime.timeName(), "uniform", runTime,
            IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE
        )
    ),
    runTime_(runTime),
    control_(timeStepControl::New(subDictOrEmpty(solution, "timeStepControl"))),
    staticStage_(solution),
    memory_({0, 0}),
    limitedBy_("deltaT"),
    size_({0, word::null}),
    meets_(-GREAT),
    trying_(false),
    clock_(true),
    firstTime_(runTime.value()),
    nRepeats_(0)
{
    readMemory();
    stopSignals::listen();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::stepControl::next()
{
    // Time::run() ends where less than half of the last step is left: after a
    // static stage that of the steps to come
    readControlDeltaT();
    if (staticStage_.endTime() > -GREAT && runTime_.deltaTValue() > memory_.controlDeltaT)
    {
        runTime_.setDeltaT(memory_.controlDeltaT, false);
    }
    const scalar left = runTime_.endTime().value() - runTime_.value();
    if (!control_->keepsPace() && left > smallPart*memory_.deltaT && left <= 0.5*runTime_.deltaTValue())
    {
        runTime_.setDeltaT(left, false);
    }
    if (!runTime_.run()) return false;
    start_ = runTime_;
    choose();
    trying_ = true;
    return true;
}


bool Foam::stepControl::attempt()
{
    if (!trying_) return false;
    static_cast<TimeState&>(runTime_) = start_;
    runTime_.setDeltaT(size_.deltaT, false);
    if (stopSignals::arrived())
    {
        Info<< "A signal asks to stop: this step is finished and written" << nl;
        runTime_.stopAt(Time::saWriteNow);
    }
    ++runTime_;
    if (meets_ > start_.value()) runTime_.setTime(meets_, runTime_.timeIndex());
    Info<< "Time = " << runTime_.timeName() << nl;
    return true;
}


void Foam::stepControl::accept(const label nIterations, const scalar error)
{
    trying_ = false;
    report(nIterations);

    const scalar taken = size_.deltaT, before = memory_.deltaT;
    if (taken >= (1 - smallPart)*memory_.failed)
    {
        memory_.failed = GREAT;
        memory_.patience = 1;
    }
    stepSize size(control_->next(taken, nIterations, error, memory_.controlDeltaT));
    if (taken < before)
    {
        // Shortened to meet a time: says nothing against the size
        size.deltaT = max(size.deltaT, min(before, before*size.deltaT/taken));
    }
    size.limit(control_->maxGrowth()*before, "growth");
    if (memory_.wait > 0)
    {
        --memory_.wait;
        size.limit(before, "bisection");
    }
    size.limit(control_->maxDeltaT(memory_.controlDeltaT), "maxDeltaT");
    const scalar least = control_->minDeltaT(memory_.controlDeltaT);
    if (size.deltaT < least) size = {least, "minDeltaT"};
    memory_.deltaT = size.deltaT;
    limitedBy_ = size.by;

    // The divided step has come to its end: so shall the next one
    const scalar whole = memory_.controlDeltaT;
    if (mag(runTime_.value() - memory_.pace) <= smallPart*whole && size.deltaT < whole*(1 - smallPart))
    {
        memory_.pace = rounded(memory_.pace + whole);
    }
}


void Foam::stepControl::bisect(const string& what, const string& where, const bool mayHelp)
{
    const scalar taken = size_.deltaT, half = 0.5*taken;
    const scalar least = control_->minDeltaT(memory_.controlDeltaT);
    static_cast<TimeState&>(runTime_) = start_;
    trying_ = mayHelp && half >= (1 - smallPart)*least;

    OStringStream os;
    os  << "The step from time " << start_.name() << " with deltaT " << fourDigits(taken)
        << " did not converge: " << what.c_str();
    if (!trying_)
    {
        os  << (mayHelp ? ". Half of it is less than minDeltaT " : ". A smaller one would not help");
        if (mayHelp) os << fourDigits(least);
        os  << '.' << nl << where.c_str();
        failure_ = os.str();
        return;
    }
    Info<< os.str().c_str() << ". It is repeated with half of that" << nl << where.c_str() << endl;

    ++nRepeats_;
    lastRepeat_ = what + " from time " + start_.name();
    memory_.wait = memory_.patience;
    memory_.patience = min(2*memory_.patience, scalar(32));
    memory_.failed = taken;
    memory_.deltaT = half;
    limitedBy_ = "bisection";
    if (control_->keepsPace() && memory_.pace <= start_.value())
    {
        memory_.pace = rounded(start_.value() + taken);
    }
    choose();
}


// ************************************************************************* //
