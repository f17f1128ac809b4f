/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "startFunctions.H"
#include "IOdictionary.H"
#include "Time.H"
#include "unknownEntries.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::startFunctions::startFunctions(const objectRegistry& region, const wordList& fields)
:
    time_(region.time().value())
{
    const Time& runTime = region.time();
    const IOdictionary dict
    (
        IOobject
        (
            "initialConditions", runTime.system(), region,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
        )
    );
    if (dict.empty()) return;
    wordList known(fields);
    known.append("time");
    reportUnknownEntries(dict, known);

    const scalar start = dict.lookupOrDefault<scalar>
    (
        "time", runTime.controlDict().lookupOrDefault<scalar>("startTime", 0)
    );
    for (const word& field : fields)
    {
        if (!dict.found(field)) continue;
        reportUnknownEntries(dict.subDict(field), spaceFunction::entries());
        if (mag(start - time_) > 1e-9*max(mag(start), runTime.deltaTValue())) continue;
        functions_.insert(field, spaceFunction(dict.subDict(field), runTime));
        Info<< "Field " << field << " of region " << region.name() << " starts as a function of space"
            << " (initialConditions)" << nl;
    }
}


// ************************************************************************* //
