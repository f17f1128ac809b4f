/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feContact.H"
#include "solidRegion.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(feContact, 0);
    addToRunTimeSelectionTable(functionObject, feContact, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::feContact::feContact
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    feFunctionObject(name, runTime, dict, "contact")
{
    read(dict);

    writeHeader(file(), "Force (N), area (m2), pressure (Pa) and gap (m), in 2-D per metre of depth");
    writeHeaderValue(file(), "Patch", mesh_.boundaryMesh()[patch_].name());
    writeColumns(file(), {"fx", "fy", "fz", "area", "pressure", "gap"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::feContact::read(const dictionary& dict)
{
    feFunctionObject::read(dict);

    reportUnknownEntries(dict, {"patch"});
    const word patch(dict.get<word>("patch"));
    wordList found;
    for (const auto& pf : solidRegion(region(), dict).motionConditions().boundaryField())
    {
        if (pf.type() == "rigidContact") found.append(pf.patch().name());
    }
    if (!found.found(patch))
    {
        FatalIOErrorInFunction(dict)
            << "Patch " << patch << " of region " << mesh_.name()
            << " is no rigidContact. Those of the region are " << found << exit(FatalIOError);
    }
    patch_ = mesh_.boundaryMesh().findPatchID(patch);
    return true;
}


bool Foam::functionObjects::feContact::execute()
{
    contact_ = solidRegion(region(), dict_).supportOf(patch_);
    setResult("force", contact_.force);
    setResult("area", contact_.area);
    setResult("pressure", contact_.traction);
    setResult("gap", contact_.gap);
    return true;
}


bool Foam::functionObjects::feContact::write()
{
    const supportTotals& c = contact_;
    Log << type() << " " << name() << " write: " << mesh_.boundaryMesh()[patch_].name() << nl
        << "    Force " << c.force << ", area " << c.area << nl
        << "    Greatest pressure " << c.traction << ", least gap " << c.gap << nl << endl;
    writeRow(file(), {c.force.x(), c.force.y(), c.force.z(), c.area, c.traction, c.gap});
    return true;
}


// ************************************************************************* //
