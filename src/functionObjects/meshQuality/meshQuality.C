/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshQuality.H"
#include "feValues.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(meshQuality, 0);
    addToRunTimeSelectionTable(functionObject, meshQuality, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::functionObjects::meshQuality::columns()
{
    wordList names({"minDetJ"});
    for (const qualityMeasure& m : qualityMeasures()) names.append(m.extreme);
    names.append("stepsToInversion");
    return names;
}


Foam::tmp<Foam::vectorField> Foam::functionObjects::meshQuality::nodes() const
{
    for (const char* field : {"pointDisplacement", "pointD"})
    {
        if (const vectorField* D = nodal<vector>(field)) return region().fe().points() + *D;
    }
    return positions();
}


template<class E>
Foam::scalar Foam::functionObjects::meshQuality::minDetJ
(
    const feMesh& fe,
    const elementBlock& block,
    const vectorField& x,
    const vectorField& X
)
{
    constexpr int d = E::dim;
    feValues<double, E> now, reference;
    Vec<double, d> xe[E::nNodes], Xe[E::nNodes];
    scalar least = GREAT;
    for (label e = 0; e < block.size(); ++e)
    {
        for (int i = 0; i < E::nNodes; ++i) for (int a = 0; a < d; ++a)
        {
            xe[i][a] = x[block.element(e)[i]][fe.axis(a)];
            Xe[i][a] = X[block.element(e)[i]][fe.axis(a)];
        }
        for (int q = 0; q < now.nQ; ++q)
        {
            now.reinit(xe, q);
            reference.reinit(Xe, q);
            least = min(least, now.detJ/reference.detJ);
        }
    }
    return least;
}


void Foam::functionObjects::meshQuality::warn(const inversionForecast& first) const
{
    if (!(first.steps < warnSteps_)) return;
    const feMesh& fe = region().fe();
    point where(-GREAT, -GREAT, -GREAT);
    label celli = -1;
    if (first.element >= 0)
    {
        celli = fe.blocks()[first.block].cells[first.element];
        where = mesh_.cellCentres()[celli];
    }
    reduce(where, maxOp<point>());
    reduce(celli, maxOp<label>());
    WarningInFunction
        << "Region " << mesh_.name() << ": at the rate of this step cell " << celli << " at "
        << where << " will be inverted in " << first.steps << " steps. Another stiffness of"
        << " the mesh motion may help, or a new mesh." << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::meshQuality::meshQuality
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    feFunctionObject(name, runTime, dict, typeName),
    warnSteps_(5)
{
    read(dict);
    reportUnknownEntries(dict, {"warnSteps"});

    writeHeader(file(), "Worst elements of the mesh");
    writeColumns(file(), columns());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::meshQuality::read(const dictionary& dict)
{
    warnSteps_ = dict.getOrDefault<scalar>("warnSteps", 5);
    return feFunctionObject::read(dict);
}


bool Foam::functionObjects::meshQuality::execute()
{
    const feMesh& fe = region().fe();
    const vectorField x(nodes());
    if (returnReduce(last_.size() != x.size(), orOp<bool>()))
    {
        reference_ = qualities(fe, fe.points());
        last_ = x;
    }

    const List<qualityMeasure>& measures = qualityMeasures();
    scalar detJ = GREAT;
    scalarList extremes(measures.size());
    forAll(measures, m) extremes[m] = measures[m].smallIsBad ? GREAT : -GREAT;
    const elementQualities now(qualities(fe, x));
    forAll(now, b)
    {
        const elementBlock& block = fe.blocks()[b];
        withElement(block, [&](auto E) { detJ = min(detJ, minDetJ<decltype(E)>(fe, block, x, fe.points())); });
        forAll(now[b], e) forAll(measures, m)
        {
            const scalar value = measures[m].of(now[b][e], reference_[b][e]);
            if (measures[m].worse(value, extremes[m])) extremes[m] = value;
        }
    }
    extremes_ = scalarList(1, returnReduce(detJ, minOp<scalar>()));
    forAll(measures, m)
    {
        measures[m].smallIsBad ? reduce(extremes[m], minOp<scalar>()) : reduce(extremes[m], maxOp<scalar>());
        extremes_.append(extremes[m]);
    }
    const inversionForecast first(forecast(fe, x, x - last_));
    extremes_.append(first.steps);
    warn(first);
    last_ = x;

    const wordList names(columns());
    forAll(names, i) setResult(names[i], extremes_[i]);
    return true;
}


bool Foam::functionObjects::meshQuality::write()
{
    Log << type() << " " << name() << " write:" << nl;
    const wordList names(columns());
    forAll(names, i) Log << "    " << names[i] << " : " << extremes_[i] << nl;
    Log << endl;

    writeRow(file(), extremes_);
    return true;
}


// ************************************************************************* //
