/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nodalProfilePointPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "fullPrecision.H"
#include "patchFieldEntries.H"
#include "unknownEntries.H"
#include "points0MotionSolver.H"
#include "Time.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    makePointPatchTypeField
    (
        pointPatchVectorField,
        nodalProfilePointPatchVectorField
    );
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::pointField>
Foam::nodalProfilePointPatchVectorField::undeformedPoints()
{
    const polyMesh& mesh = patch().boundaryMesh().mesh()();
    const labelList& points = patch().meshPoints();

    const HashTable<const points0MotionSolver*> solvers
    (
        mesh.lookupClass<points0MotionSolver>()
    );
    if (!solvers.empty())
    {
        return tmp<pointField>(new pointField((*solvers.cbegin())->points0(), points));
    }

    if (!points0_.valid())
    {
        const pointIOField all(points0MotionSolver::points0IO(mesh));

        // A file of another size belongs to the mesh before it was changed
        const bool fits = all.size() == mesh.nPoints();
        points0_.reset(new pointField(fits ? all : mesh.points(), points));
    }
    return tmp<pointField>(points0_());
}


void Foam::nodalProfilePointPatchVectorField::setValues()
{
    const scalar t = db().time().timeOutputValue();
    const tmp<pointField> tx(undeformedPoints());
    const pointField& x = tx();
    vectorField& u = *this;
    forAll(u, i) u[i] = at(x[i], t);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nodalProfilePointPatchVectorField::nodalProfilePointPatchVectorField
(
    const pointPatch& p,
    const internal& iF
)
:
    fixedValuePointPatchVectorField(p, iF),
    scale_(1)
{}


Foam::nodalProfilePointPatchVectorField::nodalProfilePointPatchVectorField
(
    const pointPatch& p,
    const internal& iF,
    const dictionary& dict
)
:
    // Not false, with which v2306 and later do not read a value that is there
    fixedValuePointPatchVectorField(p, iF, dict, dict.found("value")),
    shape_(dict, iF.db().time()),
    scale_("scale", dict, 1)
{
    reportUnknownEntries(dict, patchFieldEntries({"scale"}, spaceFunction::entries()));
    if (!dict.found("value")) setValues();
}


Foam::nodalProfilePointPatchVectorField::nodalProfilePointPatchVectorField
(
    const thisType& ptf,
    const pointPatch& p,
    const internal& iF,
    const pointPatchFieldMapper& mapper
)
:
    fixedValuePointPatchVectorField(ptf, p, iF, mapper),
    shape_(ptf.shape_),
    scale_(ptf.scale_)
{}


Foam::nodalProfilePointPatchVectorField::nodalProfilePointPatchVectorField
(
    const thisType& ptf,
    const internal& iF
)
:
    fixedValuePointPatchVectorField(ptf, iF),
    shape_(ptf.shape_),
    scale_(ptf.scale_)
{}


Foam::nodalProfilePointPatchVectorField::nodalProfilePointPatchVectorField
(
    const thisType& ptf
)
:
    nodalProfilePointPatchVectorField(ptf, ptf.internalField())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::nodalProfilePointPatchVectorField::at
(
    const point& x,
    const scalar t
) const
{
    return scale_(t)*shape_(x, t);
}


void Foam::nodalProfilePointPatchVectorField::autoMap
(
    const pointPatchFieldMapper& mapper
)
{
    fixedValuePointPatchVectorField::autoMap(mapper);
    points0_.clear();
}


void Foam::nodalProfilePointPatchVectorField::rmap
(
    const pointPatchVectorField& field,
    const labelList& addressing
)
{
    fixedValuePointPatchVectorField::rmap(field, addressing);
    points0_.clear();
}


void Foam::nodalProfilePointPatchVectorField::updateCoeffs()
{
    if (updated()) return;

    setValues();
    fixedValuePointPatchVectorField::updateCoeffs();
}


void Foam::nodalProfilePointPatchVectorField::write(Ostream& os) const
{
    pointPatchVectorField::write(os);
    {
        const fullPrecision exact(os);
        shape_.write(os);
        scale_.write(os);
    }
    writeEntry("value", os);
}


// ************************************************************************* //
