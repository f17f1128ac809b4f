/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rigidContactPointPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "readNumber.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineNamedTemplateTypeNameAndDebug(rigidContactPointPatchVectorField, 0);
    addToPointPatchFieldRunTimeSelection
    (
        pointPatchVectorField,
        rigidContactPointPatchVectorField
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rigidContactLoad::rigidContactLoad(const dictionary& dict, const Time&)
:
    dict_(dict.subDict("surface")),
    surface_(rigidSurface::New(dict_)),
    penalty_(readNumber(dict, "penalty", dimPressure/dimLength, 0, GREAT)),
    displacement_("displacement", dict, Zero)
{}


Foam::rigidContactLoad::rigidContactLoad(const rigidContactLoad& c)
:
    dict_(c.dict_),
    surface_(c.surface_.valid() ? c.surface_->clone() : nullptr),
    penalty_(c.penalty_),
    displacement_(c.displacement_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::rigidContactLoad::check
(
    const DimensionedField<vector, pointMesh>& field,
    const dictionary& dict
) const
{
    onlyOfDisplacement(typeName_(), field, dict);
    surface_->check(field.mesh()().geometricD(), dict_);
}


Foam::surfaceSupport::reaction Foam::rigidContactLoad::at
(
    const point& X,
    const vector& D,
    const vector&,
    const scalar t
) const
{
    const rigidSurface::distance d = surface_->at(X + D - displacement_(t));
    reaction a;
    a.gap = d.gap;
    if (d.gap > 0) return a;
    const scalar p = -penalty_*d.gap;
    a.traction = p*d.normal;
    a.stiffness = penalty_*sqr(d.normal) - p*d.dNormal;
    return a;
}


void Foam::rigidContactLoad::write(Ostream& os) const
{
    dict_.writeEntry("surface", os);
    os.writeEntry("penalty", penalty_);
    displacement_.write(os);
}


// ************************************************************************* //
