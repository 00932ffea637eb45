#pragma once

#include <QDialog>
#include <QString>
#include <QStringList>
#include <QUrl>
#include <vector>

class QLineEdit;
class QToolButton;
class QTreeWidget;

namespace widgets {

class GuideBrowser;

/// Folder of the documentation: installed with the program, or that of the sources; empty when
/// there is none.
QString guideFolder();

/// The user guide: the pages of docs/, their headings at the left, links between them, search
/// through all of them. Needs no network. Lives beside the main window.
class GuideWindow : public QDialog {
    Q_OBJECT
  public:
    explicit GuideWindow(QWidget* parent = nullptr);
    ~GuideWindow() override;

    /// Shows a page ("studio.md") at a heading as links name it ("running"), or at its top. False
    /// when there is no such page.
    bool showPage(const QString& page, const QString& heading = {});

    QString page() const { return page_; }

    /// The heading at the top of what is on show.
    QString headingOnShow() const;

    /// Marks the next place with this text after the present one, also on other pages. False when
    /// there is none.
    bool findNext(const QString& text);

    bool canGoBack() const { return place_ > 0; }

    void goBack();
    void goForward();

  protected:
    void changeEvent(QEvent* event) override;

  private:
    struct Place {
        QString page, heading;
    };

    void fillContents();
    bool load(const QString& page, const QString& heading);
    void scrollTo(const QString& heading);
    void follow(const QUrl& link);
    void updateButtons();
    void drawIcons();

    QStringList pages_;
    QString page_;
    std::vector<Place> places_;
    int place_ = -1;
    GuideBrowser* text_ = nullptr;
    QTreeWidget* contents_ = nullptr;
    QLineEdit* search_ = nullptr;
    QToolButton* back_ = nullptr;
    QToolButton* forward_ = nullptr;
};

/// Name of a heading in links, as code hosts make it: "Looking back!" -> "looking-back".
QString headingName(const QString& heading);

}  // namespace widgets
