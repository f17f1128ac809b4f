/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feRigidPatch.H"
#include "mathematicalConstants.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(feRigidPatch, 0);
    addToRunTimeSelectionTable(functionObject, feRigidPatch, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::functionObjects::feRigidPatch::addTurns(vector& rotation) const
{
    // The axis of a rotation by nil, or by whole turns, is any
    const scalar angle = mag(rotation), before = mag(rotation_);
    const vector axis(angle > 1e-6 ? rotation/angle : before > 1e-6 ? rotation_/before : vector::zero);
    const scalar turns = std::round(((rotation_ & axis) - angle)/constant::mathematical::twoPi);
    rotation += (constant::mathematical::twoPi*turns)*axis;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::feRigidPatch::feRigidPatch
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    feFunctionObject(name, runTime, dict, "rigidPatch"),
    rotation_(getProperty<vector>("rotation", Zero))
{
    read(dict);

    writeHeader
    (
        file(),
        "Displacement (m), rotation (rad), force (N) and moment (N m), in 2-D per metre of depth"
    );
    writeHeaderValue(file(), "Patch", patch_);
    writeColumns
    (
        file(), {"dx", "dy", "dz", "rx", "ry", "rz", "fx", "fy", "fz", "mx", "my", "mz"}
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::feRigidPatch::read(const dictionary& dict)
{
    feFunctionObject::read(dict);

    reportUnknownEntries(dict, {"patch"});
    patch_ = dict.get<word>("patch");
    wordList found;
    for (const rigidMotion& m : region().rigidMotions()) found.append(m.patch);
    if (!found.found(patch_))
    {
        FatalIOErrorInFunction(dict)
            << "Patch " << patch_ << " of region " << mesh_.name()
            << " is no rigidPatch. Those of the region are " << found << exit(FatalIOError);
    }
    return true;
}


bool Foam::functionObjects::feRigidPatch::execute()
{
    for (const rigidMotion& m : region().rigidMotions()) if (m.patch == patch_) motion_ = m;
    addTurns(motion_.rotation);
    rotation_ = motion_.rotation;
    setProperty("rotation", rotation_);
    setResult("displacement", motion_.displacement);
    setResult("rotation", motion_.rotation);
    setResult("force", motion_.force);
    setResult("moment", motion_.moment);
    return true;
}


bool Foam::functionObjects::feRigidPatch::write()
{
    Log << type() << " " << name() << " write: " << patch_ << nl
        << "    Displacement " << motion_.displacement << ", rotation " << motion_.rotation << nl
        << "    Force " << motion_.force << ", moment " << motion_.moment << nl << endl;

    scalarList row;
    for (const vector* v : {&motion_.displacement, &motion_.rotation, &motion_.force, &motion_.moment})
    {
        for (direction c = 0; c < 3; ++c) row.append((*v)[c]);
    }
    writeRow(file(), row);
    return true;
}


// ************************************************************************* //
