/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Ostream.H"
#include "Istream.H"
#include "token.H"
#include <algorithm>
#include <cmath>

template<class FieldType>
void Foam::fieldPart<FieldType>::shift()
{
    f().forLevels([](const char*, const auto& now, auto& old) { old = now; });
}


template<class FieldType>
Foam::label Foam::fieldPart<FieldType>::nScalars() const
{
    label n = 0;
    f().forLevels([&](const char*, const auto& now, const auto& old)
    {
        typedef typename std::decay<decltype(now[0])>::type Type;
        n += pTraits<Type>::nComponents*(now.size() + old.size());
    });
    return n;
}


template<class FieldType>
Foam::scalar* Foam::fieldPart<FieldType>::copy(scalar* to) const
{
    f().forLevels([&](const char*, const auto& now, const auto& old)
    {
        for (const auto* list : {&now, &old})
        {
            const scalar* from = reinterpret_cast<const scalar*>(list->cdata());
            to = std::copy(from, from + list->byteSize()/sizeof(scalar), to);
        }
    });
    return to;
}


template<class FieldType>
const Foam::scalar* Foam::fieldPart<FieldType>::set(const scalar* from)
{
    f().forLevels([&](const char*, auto& now, auto& old)
    {
        for (auto* list : {&now, &old})
        {
            const label n = list->byteSize()/sizeof(scalar);
            std::copy(from, from + n, reinterpret_cast<scalar*>(list->data()));
            from += n;
        }
    });
    return from;
}


template<class FieldType>
void Foam::fieldPart<FieldType>::write(Ostream& os) const
{
    f().forLevels([&](const char* level, const auto& now, const auto&)
    {
        os << word(name() + level) << token::SPACE << now << nl;
    });
}


template<class FieldType>
void Foam::fieldPart<FieldType>::read(Istream& is)
{
    f().forLevels([&](const char* level, auto& now, auto&)
    {
        const word expected(name() + level);
        const label n = now.size();
        const word found(is);
        is >> now;
        if (found != expected || now.size() != n)
        {
            FatalIOErrorInFunction(is)
                << "Found '" << found << "' with " << now.size()
                << " values, expected '" << expected << "' with " << n << '.' << nl
                << "The state was written for another mesh or another kind of"
                << " elements: remove this file to start from the point fields"
                << exit(FatalIOError);
        }
        for (const auto& x : now)
        {
            typedef typename std::decay<decltype(x)>::type Type;
            for (direction c = 0; c < pTraits<Type>::nComponents; ++c)
            {
                if (std::isfinite(component(x, c))) continue;
                FatalIOErrorInFunction(is)
                    << "'" << found << "' has values that are not finite numbers:"
                    << " the file is corrupt" << exit(FatalIOError);
            }
        }
    });
}


template<class FieldType>
void Foam::fieldPart<FieldType>::map(const stateMap& m)
{
    if (on() == fieldLayout::support::BODIES) return;
    f().forLevels([&](const char*, auto& now, auto& old)
    {
        // Some parts are empty
        for (auto* list : {&now, &old}) if (!list->empty()) *list = m.at(on())(*list);
    });
}


template<class FieldType>
Foam::HashTable<Foam::scalarField*> Foam::fieldPart<FieldType>::scalars() const
{
    HashTable<scalarField*> table;
    f().forLevels([&](const char* level, auto& now, auto&) { insert(table, name() + level, now); });
    return table;
}


template<class FieldType>
Foam::HashTable<Foam::vectorField*> Foam::fieldPart<FieldType>::vectors() const
{
    HashTable<vectorField*> table;
    f().forLevels([&](const char* level, auto& now, auto&) { insert(table, name() + level, now); });
    return table;
}


template<class Type>
const Foam::Field<Type>* Foam::regionState::find(const word& name) const
{
    for (const statePart& p : parts_)
    {
        if constexpr (std::is_same<Type, vector>::value)
        {
            const auto table(p.vectors());
            if (table.found(name)) return table[name];
        }
        else
        {
            const auto table(p.scalars());
            if (table.found(name)) return table[name];
        }
    }
    return nullptr;
}


// ************************************************************************* //
