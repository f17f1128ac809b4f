/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What nonlinearSolid tells others at the end of a step: fields, stresses and
    strains, forces, integrals, warnings.
\*---------------------------------------------------------------------------*/

#include "nonlinearSolid.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarField Foam::nonlinearSolid::endPressure() const
{
    scalarField p(pressure_.v);
    forAll(p, i) p[i] = pressure_.atEnd(timeScheme(), i);
    return p;
}


template<class F>
void Foam::nonlinearSolid::withPoints(const F& f) const
{
    const scalarField p(endPressure()), cells(assembly_->cellPressure(p));
    const bool nodal = elements_.mixed && elements_.pressureOn == fieldLayout::support::VERTICES;
    f(solidPoints(fe(), assembly_(), motion_.D, cells, nodal ? &p : nullptr, history_));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::vectorField> Foam::nonlinearSolid::loads() const
{
    tmp<vectorField> tforce(new vectorField(fe().nNodes(), Zero));
    addLoads(tforce.ref(), nullptr);
    tforce.ref() *= -1;
    return tforce;
}


Foam::tmp<Foam::vectorField> Foam::nonlinearSolid::viscousForces() const
{
    tmp<vectorField> tforce(new vectorField(fe().nNodes(), Zero));
    if (assembly_->viscous())
    {
        assembly_->addViscous
        (
            stage_(), timeScheme(), stageVelocity_, motion_.D, history_, tforce.ref(), nullptr, scatter_
        );
    }
    return tforce;
}


Foam::tmp<Foam::vectorField> Foam::nonlinearSolid::supports(const labelUList& patches) const
{
    tmp<vectorField> tforce(new vectorField(fe().nNodes(), Zero));
    stageLoads().addSupports(patches, stageVelocity_, 0, tforce.ref(), nullptr);
    tforce.ref() *= -1;
    return tforce;
}


Foam::supportTotals Foam::nonlinearSolid::supportOf(const label patchi) const
{
    supportTotals sum(stageLoads().supportOf(patchi, stageVelocity_));
    reduce(sum.force, sumOp<vector>());
    reduce(sum.area, sumOp<scalar>());
    reduce(sum.traction, maxOp<scalar>());
    reduce(sum.gap, minOp<scalar>());
    return sum;
}


Foam::solidIntegrals Foam::nonlinearSolid::integrals() const
{
    autoPtr<solidIntegrals> all;
    withPoints([&](const solidPoints& points)
    {
        all.reset(new solidIntegrals(fe(), assembly_(), g_.value(), motion_, points));
    });
    return all();
}


template<class Type>
Foam::tmp<Foam::Field<Type>>
Foam::nonlinearSolid::cellValues(Type (solidPoint::*of)() const) const
{
    tmp<Field<Type>> tvalues;
    withPoints([&](const solidPoints& points) { tvalues = points.cells<Type>(of); });
    return tvalues;
}


template<class Type>
Foam::tmp<Foam::Field<Type>>
Foam::nonlinearSolid::pointValues(Type (solidPoint::*of)() const) const
{
    tmp<Field<Type>> tvalues(new Field<Type>(mesh_.nPoints(), Zero));
    withPoints([&](const solidPoints& points)
    {
        fe().toPoints<Type>(points.vertices<Type>(of)(), tvalues.ref());
    });
    return tvalues;
}


void Foam::nonlinearSolid::derive()
{
    fe().toPoints<vector>(motion_.D, pointD_->primitiveFieldRef());
    toCells<vector>(motion_.D, D_);

    withPoints([&](const solidPoints& points)
    {
        sigma_.primitiveFieldRef() = points.cells<symmTensor>(&solidPoint::sigma);
        watch_->check(points, motion_.D);
    });
    sigma_.correctBoundaryConditions();
    if (elements_.mixed)
    {
        solidPressure_->primitiveFieldRef() = assembly_->cellPressure(endPressure());
        solidPressure_->correctBoundaryConditions();
    }
    const symmTensorField s(dev(sigma_.primitiveField()));
    sigmaEq_.primitiveFieldRef() = sqrt(1.5*magSqr(s));
    sigmaEq_.correctBoundaryConditions();
}


#define instantiate(Type)                                                      \
    template Foam::tmp<Foam::Field<Foam::Type>>                                \
    Foam::nonlinearSolid::cellValues(Type (solidPoint::*of)() const) const;    \
    template Foam::tmp<Foam::Field<Foam::Type>>                                \
    Foam::nonlinearSolid::pointValues(Type (solidPoint::*of)() const) const;

instantiate(scalar)
instantiate(vector)
instantiate(symmTensor)
instantiate(tensor)

#undef instantiate


// ************************************************************************* //
