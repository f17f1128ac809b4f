/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feFlowRate.H"
#include "patchIntegrals.H"
#include "pointFields.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(feFlowRate, 0);
    addToRunTimeSelectionTable(functionObject, feFlowRate, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::feFlowRate::feFlowRate
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    feFunctionObject(name, runTime, dict, "flowRate"),
    flowRate_(0),
    meanPressure_(0),
    area_(0)
{
    read(dict);
    writeHeader(file(), "Flow rate outwards (m3/s), mean pressure (Pa), area (m2), in 2-D per metre of depth");
    writeColumns(file(), {"flowRate", "meanPressure", "area"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::feFlowRate::read(const dictionary& dict)
{
    feFunctionObject::read(dict);
    reportUnknownEntries(dict, {"patches"});
    patches_ = region().fe().patchIndices(dict.get<wordRes>("patches"), dict);
    if (!nodal<vector>("pointU"))
    {
        FatalIOErrorInFunction(dict)
            << "Region " << mesh_.name() << " is no fluid, whose flow rate could be told" << exit(FatalIOError);
    }
    return true;
}


bool Foam::functionObjects::feFlowRate::execute()
{
    const feMesh& fe = region().fe();
    const word pressureName(mesh_.foundObject<pointScalarField>("pointPSmoothed") ? "pointPSmoothed" : "pointP");
    const auto& pressure = mesh_.lookupObject<pointScalarField>(pressureName);
    const patchIntegrals at
    (
        fe, patches_, positions(), *nodal<vector>("pointU"), fe.interpolate<scalar>(pressure.primitiveField())
    );
    flowRate_ = at.flux;
    area_ = at.area;
    meanPressure_ = at.integral/max(at.area, VSMALL);
    setResult("flowRate", flowRate_);
    setResult("meanPressure", meanPressure_);
    return true;
}


bool Foam::functionObjects::feFlowRate::write()
{
    Log << type() << " " << name() << " write:" << nl
        << "    flow rate " << flowRate_ << ", mean pressure " << meanPressure_ << nl << endl;
    writeRow(file(), {flowRate_, meanPressure_, area_});
    return true;
}


// ************************************************************************* //
