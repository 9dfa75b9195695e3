//! Markdown of a report as HTML inside a page: links lead to places of the page, pictures stand in it.

use pulldown_cmark::{CowStr, Event, HeadingLevel, Options, Parser, Tag, TagEnd, html};

/// Renders Markdown. Headings are two levels lower; `picture` gives the SVG of a file name, and a picture that it does not know is left out.
pub(super) fn html(markdown: &str, picture: impl Fn(&str) -> Option<String>) -> String {
    let mut events = Vec::new();
    let (mut in_cell, mut in_image) = (false, false);
    for (event, range) in Parser::new_ext(markdown, Options::ENABLE_TABLES).into_offset_iter() {
        match event {
            // an underscore belongs to a formula
            Event::Start(Tag::Emphasis) | Event::End(TagEnd::Emphasis) if markdown[range.start..].starts_with('_') => {
                events.push(Event::Text("_".into()));
            }
            // what stands for a picture in words is in the picture
            Event::End(TagEnd::Image) => in_image = false,
            _ if in_image => {}
            Event::Start(Tag::Image { dest_url, .. }) => {
                in_image = true;
                let figure = |svg| Event::InlineHtml(format!("<span class=\"figure\">{svg}</span>").into());
                events.extend(picture(&dest_url).map(figure));
            }
            Event::Start(Tag::Table(_)) => events.extend([raw("<div class=\"scroll\">"), event]),
            Event::End(TagEnd::Table) => events.extend([event, raw("</div>")]),
            Event::Start(Tag::Heading { level, id, classes, attrs }) => {
                events.push(Event::Start(Tag::Heading { level: lower(level), id, classes, attrs }));
            }
            Event::End(TagEnd::Heading(level)) => events.push(Event::End(TagEnd::Heading(lower(level)))),
            Event::Start(Tag::Link { link_type, dest_url, title, id }) => {
                events.push(Event::Start(Tag::Link { link_type, dest_url: place(&dest_url).into(), title, id }));
            }
            Event::Text(words) if in_cell => events.push(verdict(words)),
            // reports hold no HTML: what looks like it is text
            Event::Html(text) | Event::InlineHtml(text) => events.push(Event::Text(text)),
            other => {
                in_cell = matches!(other, Event::Start(Tag::TableCell))
                    || in_cell && !matches!(other, Event::End(TagEnd::TableCell));
                events.push(other);
            }
        }
    }
    let mut out = String::new();
    html::push_html(&mut out, events.into_iter());
    out
}

fn raw(text: &'static str) -> Event<'static> {
    Event::Html(text.into())
}

fn lower(level: HeadingLevel) -> HeadingLevel {
    match level {
        HeadingLevel::H1 => HeadingLevel::H3,
        HeadingLevel::H2 => HeadingLevel::H4,
        HeadingLevel::H3 => HeadingLevel::H5,
        _ => HeadingLevel::H6,
    }
}

/// Where a link between files leads on the page.
fn place(link: &str) -> String {
    match link {
        "summary.md" => "#cases".into(),
        "statements.md" => "#statements".into(),
        "hard.md" => "#hard".into(),
        _ => match link.strip_suffix("/report.md") {
            Some(folder) => format!("#{folder}"),
            None => link.into(),
        },
    }
}

/// A verdict in a table, told apart by more than its words.
fn verdict(words: CowStr) -> Event {
    match class(&words) {
        Some(class) => Event::InlineHtml(format!("<span class=\"verdict {class}\">{words}</span>").into()),
        None => Event::Text(words),
    }
}

/// The class of a cell that holds a verdict and nothing else.
pub(super) fn class(words: &str) -> Option<&'static str> {
    let words = words.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start();
    let classes = [("pass", "pass"), ("fail", "fail"), ("inconclusive", "inconclusive")];
    let found = classes.into_iter().find(|(word, _)| words == *word || words.starts_with(&format!("{word} (")))?;
    let met = words.ends_with("(ok)") || words.ends_with("(wanted)");
    Some(if met { "met" } else { found.1 })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain(markdown: &str) -> String {
        html(markdown, |file| (file == "rates.png").then(|| "<svg/>".into()))
    }

    #[test]
    fn pictures_stand_in_the_page_and_missing_ones_are_left_out() {
        assert_eq!(plain("![Errors](rates.png)"), "<p><span class=\"figure\"><svg/></span></p>\n");
        assert_eq!(plain("a ![Errors](other.png) b"), "<p>a  b</p>\n");
    }

    #[test]
    fn links_between_reports_lead_to_places_of_the_page() {
        assert_eq!(plain("[x](hertz/a/report.md)"), "<p><a href=\"#hertz/a\">x</a></p>\n");
        assert_eq!(plain("[x](summary.md)"), "<p><a href=\"#cases\">x</a></p>\n");
    }

    #[test]
    fn verdicts_in_tables_have_their_class() {
        let table = plain("| a | b |\n| --- | --- |\n| pass | inconclusive (ok) |\n");
        assert!(table.contains("<span class=\"verdict pass\">pass</span>"), "{table}");
        assert!(table.contains("<span class=\"verdict met\">inconclusive (ok)</span>"), "{table}");
        assert_eq!((class("passes"), class("4 pass"), class("3 pass, 2 fail")), (None, Some("pass"), None));
        assert_eq!(class("fail (wanted)"), Some("met"));
        assert!(plain("pass").starts_with("<p>pass"));
    }

    #[test]
    fn what_looks_like_markup_is_text() {
        assert_eq!(plain("a <script>b</script>"), "<p>a &lt;script&gt;b&lt;/script&gt;</p>\n");
        assert_eq!(plain("## A"), "<h4>A</h4>\n");
        assert_eq!(plain("|u'_n|_{1,∞} and *so*"), "<p>|u'_n|_{1,∞} and <em>so</em></p>\n");
    }
}
