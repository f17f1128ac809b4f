/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dictionaryFiles.H"
#include "IFstream.H"
#include "OSspecific.H"
#include <cctype>
#include <cstring>
#include <iterator>
#include <regex>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static bool inWord(const char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dictionaryFiles::add(const fileName& file)
{
    if (!isFile(file) || names_.found(file)) return;

    IFstream is(file);
    const std::string text
    (
        (std::istreambuf_iterator<char>(is.stdStream())),
        std::istreambuf_iterator<char>()
    );
    names_.append(file);
    texts_.append(text);

    static const std::regex include("#s?include(?:IfPresent)?\\s+\"([^\"]+)\"");
    for (std::sregex_iterator i(text.begin(), text.end(), include), end; i != end; ++i)
    {
        fileName other((*i)[1].str());
        other.expand();
        add(other.isAbsolute() ? other : file.path()/other);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordHashSet Foam::dictionaryFiles::macros() const
{
    wordHashSet names;
    for (const std::string& text : texts_)
    {
        for (auto i = text.find('$'); i != std::string::npos; i = text.find('$', i + 1))
        {
            // The text behind the last character ends the name
            std::string name;
            for (auto j = i + 1; j <= text.size(); ++j)
            {
                const char c = j < text.size() ? text[j] : '\n';
                if (inWord(c))
                {
                    name += c;
                    continue;
                }
                if (!name.empty()) names.insert(word(name, false));
                name.clear();
                if (!strchr("{:./^", c)) break;
            }
        }
    }
    return names;
}


Foam::fileName Foam::dictionaryFiles::with(const std::string& word) const
{
    forAll(texts_, f)
    {
        const std::string& text = texts_[f];
        for (auto i = text.find(word); i != std::string::npos; i = text.find(word, i + 1))
        {
            const auto end = i + word.size();
            const bool whole =
                (i == 0 || !inWord(text[i - 1])) && (end == text.size() || !inWord(text[end]));
            if (whole) return names_[f];
        }
    }
    return fileName();
}


// ************************************************************************* //
