/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "remeshCriteria.H"
#include "addToRunTimeSelectionTable.H"
#include "subDictOrEmpty.H"
#include "unknownEntries.H"
#include "PstreamReduceOps.H"
#include "OStringStream.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace remeshCriteria
{
    defineTypeNameAndDebug(quality, 0);
    defineTypeNameAndDebug(inversion, 0);
    defineTypeNameAndDebug(times, 0);
    addToRunTimeSelectionTable(remeshCriterion, quality, dictionary);
    addToRunTimeSelectionTable(remeshCriterion, inversion, dictionary);
    addToRunTimeSelectionTable(remeshCriterion, times, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static void checkPositive(const dictionary& dict, const word& name, const scalar value)
{
    if (value > 0) return;
    FatalIOErrorInFunction(dict)
        << name << " is " << value << ", expected a number > 0" << exit(FatalIOError);
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::remeshCriteria::quality::quality(const dictionary& dict)
:
    limits_(subDictOrEmpty(dict, "limits")),
    interval_(dict.getOrDefault<label>("interval", 1))
{
    reportUnknownEntries(dict, {"type", "limits", "interval"});
    checkPositive(dict, "interval", interval_);
}


Foam::remeshCriteria::inversion::inversion(const dictionary& dict)
:
    steps_(dict.getOrDefault<scalar>("steps", 5))
{
    reportUnknownEntries(dict, {"type", "steps"});
    checkPositive(dict, "steps", steps_);
}


Foam::remeshCriteria::times::times(const dictionary& dict)
:
    times_(dict.getOrDefault<scalarList>("times", scalarList())),
    interval_(dict.getOrDefault<scalar>("interval", GREAT))
{
    reportUnknownEntries(dict, {"type", "times", "interval"});
    checkPositive(dict, "interval", interval_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::remeshCriteria::quality::broken(const moment& m, labelHashSet& bad) const
{
    const elementQualities now(qualities(m.fe, m.x)), reference(qualities(m.fe, m.fe.points()));
    const List<qualityMeasure>& measures = qualityMeasures();
    forAll(now, b) forAll(now[b], e) forAll(measures, k)
    {
        if (limits_.broken(k, measures[k].of(now[b][e], reference[b][e]))) bad.insert(m.fe.blocks()[b].cells[e]);
    }
    return limits_.nBroken(now, reference);
}


Foam::string Foam::remeshCriteria::quality::asks(const moment& m, labelHashSet& bad) const
{
    if (m.time.timeIndex() % interval_) return "";
    const labelList n(broken(m, bad));
    OStringStream os;
    forAll(n, k)
    {
        if (!n[k]) continue;
        os << (os.str().empty() ? "" : ", ") << n[k] << " elements past the limit of "
            << qualityMeasures()[k].name;
    }
    return os.str();
}


Foam::label Foam::remeshCriteria::quality::nAtStart(const moment& m) const
{
    labelHashSet bad;
    broken(m, bad);
    return returnReduce(bad.size(), sumOp<label>());
}


Foam::string Foam::remeshCriteria::inversion::asks(const moment& m, labelHashSet& bad) const
{
    const inversionForecast first(forecast(m.fe, m.x, m.dx));
    if (!(first.steps <= steps_)) return "";
    if (first.element >= 0) bad.insert(m.fe.blocks()[first.block].cells[first.element]);
    OStringStream os;
    os << "an element will be inverted in " << first.steps << " steps";
    return os.str();
}


Foam::string Foam::remeshCriteria::times::asks(const moment& m, labelHashSet&) const
{
    // The step that has ended at or after it
    const scalar small = 1e-9*m.time.deltaTValue();
    const scalar end = m.time.value() + small, start = end - m.time.deltaTValue();
    bool now = std::floor(end/interval_) > std::floor(start/interval_);
    for (const scalar t : times_) now = now || (start < t && t <= end);
    return now ? "its time has come" : "";
}


// ************************************************************************* //
