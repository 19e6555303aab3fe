// The page: whatever a student's code put into a message, it stays whole and refers to nothing
// outside.
#include "report_texts.h"

#include <criterion/redirect.h>

Test(report_html, escapes_every_message)
{
    Result result = result_make("<script>alert('1')</script> & \"quotes\" \x01 \xFF </p>");
    result.stages[0].message = strdup("<img src=x onerror=alert(1)>\n</pre><b>");
    result.submission = "labs/\"><script>";
    strcpy(result.device, "<svg onload=x>");
    result.n_pictures = 1;
    strcpy(result.pictures[0].title, "</h3><script>");
    char *page = file_report(report_html, &result);
    static const char *const never[] = {"<script", "<img", "<b>evil", "<svg",
                                        "\x01",    "\xFF", "</p> <",  "&lt;/p></p>"};
    for (size_t i = 0; i < sizeof never / sizeof never[0]; i++) {
        expect_no_part(page, never[i]);
    }
    expect_part(
        page,
        "&lt;script&gt;alert(&#39;1&#39;)&lt;/script&gt; &amp; &quot;quotes&quot; \\x01 \\xFF "
        "&lt;/p&gt;</p>");
    expect_part(
        page, "<pre class=\"log\">&lt;img src=x onerror=alert(1)&gt;\n&lt;/pre&gt;&lt;b&gt;</pre>");
    expect_part(page, "Compare the squares.");
    expect_no_part(page, "Remember the depth.");
    free(page);
    result_free(&result);
}

Test(report_html, tells_the_figure_of_a_race_where_there_is_one)
{
    Result result = full_result_make(12.3);
    char *page = file_report(report_html, &result);
    expect_part(page, "<b class=\"number\">12.3</b> times as fast as lab 00&#39;s &lt;kernel&gt; "
                      "on this device, in this run; gives and costs no points</p>");
    free(page);
    result.leaderboard = 0;
    page = file_report(report_html, &result);
    expect_no_part(page, "times as fast");
    free(page);
    result_free(&result);
}

static Image picture_make(int width, float value)
{
    Image image;
    cr_assert_eq(image_create(width, 2, &image), 0);
    image.pixels[0] = value;
    return image;
}

static int count_parts(const char *text, const char *part)
{
    int n = 0;
    for (const char *at = text; (at = strstr(at, part)) != NULL; at++) {
        n++;
    }
    return n;
}

Test(report_html, embeds_pictures_and_refers_to_nothing_outside)
{
    static const char svg[] = "<svg xmlns=\"http://www.w3.org/2000/svg\"></svg>";
    Result result = result_make("wrong");
    result.n_pictures = 4;
    result.pictures[0] = (PictureResult){.title = "both"};
    result.pictures[0].reference = picture_make(3, 1);
    result.pictures[0].own = picture_make(3, 0);
    result.pictures[1] = (PictureResult){.title = "sizes"};
    result.pictures[1].reference = picture_make(3, 1);
    result.pictures[1].own = picture_make(4, 1);
    result.pictures[2] = (PictureResult){.title = "none", .reference = picture_make(3, 1)};
    result.pictures[3] = (PictureResult){.title = "tree", .svg_reference = strdup(svg)};
    char *page = file_report(report_html, &result);
    cr_expect_eq(count_parts(page, "src=\"data:image/png;base64,iVBORw0KGgo"), 3 + 2 + 1);
    cr_expect_eq(count_parts(page, "src=\"data:image/svg+xml;base64,PHN2Zy"), 1);
    cr_expect_eq(count_parts(page, "src="), 3 + 2 + 1 + 1);
    expect_part(page, "the reference is 3&times;2, yours 4&times;2");
    // The difference has a legend, and nothing else has.
    cr_expect_eq(count_parts(page, "<div class=\"legend\">"), 1);
    expect_part(page, "linear-gradient(to right, #000004, ");
    expect_part(page, ", #fcffa4)");
    expect_part(page, "<span>0</span><span>0.125</span><span>0.25</span><span>0.375</span>"
                      "<span>&ge; 0.5</span>");
    expect_part(page, "content=\"default-src 'none'; img-src data:; style-src 'unsafe-inline'\"");
    expect_no_part(page, "http:");
    expect_no_part(page, "https:");
    expect_no_part(page, "<script");
    expect_no_part(page, "url(");
    expect_no_part(page, "@import");
    free(page);
    result_free(&result);
}

Test(report_html, leaves_the_old_page_when_it_cannot_be_written, .init = cr_redirect_stderr)
{
    Result result = result_make("wrong");
    cr_expect_eq(report_html("/nowhere/report.html", &manifest, &result), -1);
    cr_expect_eq(report_html("/dev/null", &manifest, &result), -1);
    result_free(&result);
}
