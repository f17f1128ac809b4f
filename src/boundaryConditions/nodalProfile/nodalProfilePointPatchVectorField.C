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

void Foam::nodalProfilePointPatchVectorField::checkExponents
(
    const dictionary& dict
) const
{
    for (const auto& term : terms_)
    {
        const vector& n = term.second();
        for (direction a = 0; a < vector::nComponents; ++a)
        {
            if (n[a] >= 0 && n[a] == std::floor(n[a])) continue;
            FatalIOErrorInFunction(dict)
                << "Term " << term << " on patch " << patch().name()
                << " has exponents " << n << ", expected whole numbers >= 0" << nl
                << "A term is (coefficient exponents), both vectors, as in"
                << " ((6 0 0) (0 1 0)) for 6 y in direction x"
                << exit(FatalIOError);
        }
    }
}


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
    origin_(Zero),
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
    terms_(dict.lookupOrDefault("terms", List<Tuple2<vector, vector>>())),
    code_(dict, iF.db().time()),
    origin_(dict.lookupOrDefault<point>("origin", Zero)),
    scale_("scale", dict, 1)
{
    reportUnknownEntries(dict, patchFieldEntries({"scale"}, {"terms", "code", "origin"}));
    checkExponents(dict);
    if (terms_.empty() && code_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Profile on patch " << p.name() << " has neither terms nor code;"
            << " expected one of them at least" << exit(FatalIOError);
    }
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
    terms_(ptf.terms_),
    code_(ptf.code_),
    origin_(ptf.origin_),
    scale_(ptf.scale_)
{}


Foam::nodalProfilePointPatchVectorField::nodalProfilePointPatchVectorField
(
    const thisType& ptf,
    const internal& iF
)
:
    fixedValuePointPatchVectorField(ptf, iF),
    terms_(ptf.terms_),
    code_(ptf.code_),
    origin_(ptf.origin_),
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
    const vector X = x - origin_;

    vector u = code_.empty() ? vector::zero : code_(X, t);
    for (const auto& term : terms_)
    {
        const vector& n = term.second();
        u += term.first()*pow(X.x(), n.x())*pow(X.y(), n.y())*pow(X.z(), n.z());
    }
    return scale_(t)*u;
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
        if (!terms_.empty()) os.writeEntry("terms", terms_);
        code_.write(os);
        if (origin_ != point::zero) os.writeEntry("origin", origin_);
        scale_.write(os);
    }
    writeEntry("value", os);
}


// ************************************************************************* //
