/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceSlipPointPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineNamedTemplateTypeNameAndDebug(surfaceSlipPointPatchVectorField, 0);
    addToPointPatchFieldRunTimeSelection
    (
        pointPatchVectorField,
        surfaceSlipPointPatchVectorField
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::surfaceSlipCondition::surfaceSlipCondition(const dictionary& dict, const Time&)
:
    dict_(dict.subDict("surface")),
    surface_(rigidSurface::New(dict_))
{}


Foam::surfaceSlipCondition::surfaceSlipCondition(const surfaceSlipCondition& c)
:
    dict_(c.dict_),
    surface_(c.surface_.valid() ? c.surface_->clone() : nullptr)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::surfaceSlipCondition::check
(
    const DimensionedField<vector, pointMesh>& field,
    const dictionary& dict
) const
{
    onlyOfDisplacement(typeName_(), field, dict);
    surface_->check(field.mesh()().geometricD(), dict_);
}


// ************************************************************************* //
